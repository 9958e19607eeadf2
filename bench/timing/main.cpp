#include <benchmark/benchmark.h>

#include "peers/peers.hpp"
#include "timing/session.hpp"

int main(int argc, char** argv) {
  benchmark::AddCustomContext("thinbench_build_type", THINBENCH_BUILD_TYPE);
  return thinbench::run_timings({argv, argv + argc}, thinbench::operations_with_peers());
}
