// Times of a run of the study, read back from its results folder.
#pragma once

#include <map>
#include <optional>
#include <string>

namespace thinbench {

/// Medians of an operation on the scene, end to end on one thread, in nanoseconds; of thinning with
/// zero padding and without a limit of iterations.
struct MeasuredTimes {
  std::optional<double> reference_ns;
  std::optional<double> best_ns;  // of the fastest variant
  std::string best_variant;       // its technique and instruction set
};

using TimesByOperation = std::map<std::string, MeasuredTimes>;

/// What `folder`/timings.csv holds. Throws std::runtime_error with one line where it cannot be read
/// or is no table of times.
[[nodiscard]] TimesByOperation read_measured_times(const std::string& folder);

}  // namespace thinbench
