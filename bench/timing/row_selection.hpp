// What the programs that time share before they start the clock.
#pragma once

#include <string>
#include <vector>

#include "timing/timed_row.hpp"

namespace thinbench {

[[nodiscard]] std::vector<Operation> without_peers(std::vector<Operation> operations);

/// select_rows of what the user requested. Reports on standard error which rows were not equal to
/// their reference and how many were skipped. Throws UsageError where nothing is left.
[[nodiscard]] Selection rows_asked_for(const std::string& filter,
                                       const std::vector<Operation>& operations,
                                       const std::vector<TimedInput>& inputs, Levels levels);

}  // namespace thinbench
