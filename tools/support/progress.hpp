// Progress on standard error: how much is done and how long the rest will take.
#pragma once

#include <chrono>
#include <string>

namespace thinbench {

/// Work is counted in expected seconds or in other units of which each takes as long, so that the
/// time left is right from the start. On a terminal one line is rewritten; elsewhere a line appears
/// every ten seconds.
class Progress {
 public:
  /// With `units`, such as "images", lines also say how many are done per second.
  Progress(std::string what, double total, std::string units = "");
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance(double done);

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] std::string line() const;

  std::string what_;
  double total_;
  std::string units_;
  double done_ = 0;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point latest_ = Clock::now();
};

}  // namespace thinbench
