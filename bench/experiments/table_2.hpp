// Table 2 of the paper, and the same ratios from times measured now.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/report.hpp"

namespace thinbench {

/// A line of Table 2: a 510 x 412 image on a Pentium II at 350 MHz.
struct PaperTime {
  const char* method;
  const char* operation;  // its name in this project
  double seconds;
};

[[nodiscard]] const std::vector<PaperTime>& paper_times();

/// A line's time relative to Naccache-Shinghal's, in the paper and, where measured, now.
struct ThenAndNow {
  PaperTime paper;
  double then_ratio;
  std::optional<double> now_ns;
  std::optional<double> now_ratio;  // needs thin_naccache_shinghal's time too
};

/// Joins Table 2 with medians in nanoseconds by name of operation.
[[nodiscard]] std::vector<ThenAndNow> then_and_now(const std::map<std::string, double>& median_ns);

/// What was not measured is left out: fields in the JSON, columns in the table when they are empty.
[[nodiscard]] ExperimentReport table_2_report(const std::vector<ThenAndNow>& rows);

}  // namespace thinbench
