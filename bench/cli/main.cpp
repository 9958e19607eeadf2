#include <iostream>

#include "cli/program.hpp"

int main(int argc, char** argv) {
  return thinbench::run_program({argv + (argc > 0 ? 1 : 0), argv + argc}, std::cout, std::cerr);
}
