// From the names of rows back to the rows, without verifying them again.
#pragma once

#include <string>
#include <vector>

#include "timing/timed_row.hpp"

namespace thinbench {

/// The six fields of case/technique/isa/threads/scope/input. Throws std::runtime_error for
/// fewer or more.
[[nodiscard]] std::vector<std::string> fields_of(const std::string& name);

/// The row of this name; it points to `operations` and `inputs`. Throws std::runtime_error where
/// there is none.
[[nodiscard]] TimedRow row_named(const std::string& name, const std::vector<Operation>& operations,
                                 const std::vector<TimedInput>& inputs);

}  // namespace thinbench
