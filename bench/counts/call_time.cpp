#include "counts/call_time.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "counts/cycles.hpp"
#include "measure/plan.hpp"
#include "measure/timed_call.hpp"

namespace thinbench {
namespace {

double seconds_of_epoch(TimedCall& call, std::int64_t calls) {
  const double start = thread_seconds();
  for (std::int64_t i = 0; i < calls; ++i) call();
  return (thread_seconds() - start) / static_cast<double>(calls);
}

}  // namespace

double seconds_of_call(const TimedRow& row, std::size_t epochs) {
  TimedCall call(row);
  call();
  const double once = std::max(seconds_of_epoch(call, 1), 1e-8);
  if (once > kSlowCall) return once;
  const std::int64_t calls = std::max<std::int64_t>(1, std::llround(kEpoch / once));
  std::vector<double> times(epochs);
  for (double& time : times) time = seconds_of_epoch(call, calls);
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(epochs / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

}  // namespace thinbench
