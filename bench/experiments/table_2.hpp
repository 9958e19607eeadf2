// Table 2 of the paper, and the same ratios from times measured now.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/measured_times.hpp"
#include "experiments/report.hpp"

namespace thinbench {

/// A line of Table 2: a 510 x 412 image on a Pentium II at 350 MHz.
struct PaperTime {
  const char* method;
  const char* operation;  // its name in this project
  double seconds;
};

[[nodiscard]] const std::vector<PaperTime>& paper_times();

/// A line's time relative to Naccache-Shinghal's, in the paper and, where measured, now: the
/// reference against the rule's reference, the best variant against the rule's best.
struct ThenAndNow {
  PaperTime paper;
  double then_ratio;
  MeasuredTimes now;
  std::optional<double> reference_ratio;
  std::optional<double> best_ratio;
};

/// Joins Table 2 with measured times by name of operation.
[[nodiscard]] std::vector<ThenAndNow> then_and_now(const TimesByOperation& times);

/// What was not measured is left out: fields in the JSON, columns in the table when they are empty.
/// `options` are the command's.
[[nodiscard]] ExperimentReport table_2_report(const std::vector<ThenAndNow>& rows,
                                              const std::string& options = "");

}  // namespace thinbench
