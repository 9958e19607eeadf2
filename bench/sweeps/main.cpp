#include "sweeps/session.hpp"

int main(int argc, char** argv) {
  return thinbench::run_sweeps({argv + (argc > 0 ? 1 : 0), argv + argc},
                               thinbench::all_operations());
}
