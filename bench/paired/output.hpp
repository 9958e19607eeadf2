// The results as files and as text.
#pragma once

#include <string>
#include <vector>

#include "paired/summary.hpp"

namespace thinbench {

/// speedups.csv; columns are only ever added at the right. `layout` is the place of source and
/// destination in a page, `flags` are separated by ';', `against_row` names the other row,
/// `operation` is the plain name: with `border` and `max_iterations`, empty where there is none, it
/// tells cases apart.
[[nodiscard]] std::string to_csv(const std::vector<PairResult>& results);

/// Raw samples as JSON lines: first what was done, then one object for each row and process with
/// ln(time / anchor's time) of every visit. The value of a process for a pair is the difference of
/// two medians. Rows on one thread have thread CPU time, rows with threads wall time, what these
/// are compared with both.
[[nodiscard]] std::string to_json_lines(const std::vector<Group>& groups,
                                        const std::vector<std::vector<GroupTimes>>& processes,
                                        const std::vector<PairResult>& results);

/// The ratios to references and of the controls, a line each.
[[nodiscard]] std::string to_table(const std::vector<PairResult>& results);

/// How many processes, which interval, what the controls say: a line.
[[nodiscard]] std::string verdict_line(const std::vector<PairResult>& results);

}  // namespace thinbench
