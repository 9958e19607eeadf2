#include "cli/thinbench.hpp"

int main(int argc, char** argv) {
  return thinbench::run_main(thinbench::thinbench_program(), argc, argv);
}
