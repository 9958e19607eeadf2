#include <benchmark/benchmark.h>

#include "timing/session.hpp"

int main(int argc, char** argv) {
  benchmark::AddCustomContext("thinbench_build_type", THINBENCH_BUILD_TYPE);
  return thinbench::run_timings({argv, argv + argc}, thinbench::all_operations());
}
