// Progress on standard error: how much is done and how long the rest will take.
#pragma once

#include <chrono>
#include <string>

namespace thinbench {

/// Work is counted in expected seconds, so that the time left is right from the start. On a
/// terminal one line is rewritten; elsewhere a line appears every ten seconds.
class Progress {
 public:
  Progress(std::string what, double expected_seconds);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance(double expected_seconds);

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] std::string line() const;

  std::string what_;
  double total_;
  double done_ = 0;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point latest_ = Clock::now();
};

}  // namespace thinbench
