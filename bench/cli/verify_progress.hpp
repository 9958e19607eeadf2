// How far a long run is: one line that renews itself on a terminal, one line a set elsewhere.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "harness/test_images.hpp"

namespace thinbench {

/// Counts images and the time they take, which grows with their pixels.
class VerifyProgress {
 public:
  /// Counts the images of all sets beforehand, to know how much is left.
  VerifyProgress(const Console& console, const std::vector<TestImageSet>& sets);

  void begin_set(std::size_t set);
  void image_done(const TestImage& image);
  void end_set();

 private:
  using Clock = std::chrono::steady_clock;
  struct Load {
    long images = 0;
    double work = 0;
    void add(const TestImage& image);
  };

  [[nodiscard]] double seconds_since(Clock::time_point start) const;
  void renew_line();

  Console console_;
  const std::vector<TestImageSet>& sets_;
  std::vector<Load> loads_;
  double all_work_ = 0;
  Load set_done_;
  double work_done_ = 0;
  std::size_t set_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point set_start_ = start_;
  Clock::time_point renewed_ = start_;
};

}  // namespace thinbench
