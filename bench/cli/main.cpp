#include <iostream>

#include "cli/program.hpp"
#include "support/unfinished_file.hpp"

int main(int argc, char** argv) {
  thinbench::remove_unfinished_files_on_signals();
  return thinbench::run_program({argv + (argc > 0 ? 1 : 0), argv + argc}, std::cout, std::cerr);
}
