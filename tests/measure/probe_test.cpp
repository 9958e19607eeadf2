#include "measure/probe.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace thinbench {
namespace {

template <class Sample>
double shortest(const Sample& sample) {
  double found = sample();
  for (int i = 0; i < 1000; ++i) found = std::min(found, sample());
  return found;
}

// A busy machine makes single samples longer, not the shortest of thousands.
TEST(Probe, TakesAFixedNumberOfClockCycles) {
  const double cycles = shortest(probe_ns) / shortest(cycle_ns);
  EXPECT_GT(cycles, 100);
  EXPECT_LT(cycles, 200000);
}

TEST(Probe, AClockCycleIsAFractionOfANanosecondOrALittleMore) {
  const double cycle = shortest(cycle_ns);
  EXPECT_GT(cycle, 0.1);
  EXPECT_LT(cycle, 10);
}

}  // namespace
}  // namespace thinbench
