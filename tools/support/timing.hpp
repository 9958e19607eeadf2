#pragma once

#include <chrono>

namespace thinbench {

template <class Work>
[[nodiscard]] double milliseconds_of(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  work();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace thinbench
