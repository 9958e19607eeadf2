// The image that instructions are counted on: small, because every instruction takes microseconds.
#pragma once

#include <string>

#include "measure/inputs.hpp"

namespace thinbench {

/// Every 5th pixel of every 16th row, named "<input>_small": the scene becomes 102 x 26 pixels,
/// more than a word in a row and few rows, with all its parts and most of their holes.
[[nodiscard]] TimedInput small_copy(const TimedInput& input);

/// At most `rows` rows from the middle, named "<input>_<rows>_rows".
[[nodiscard]] TimedInput middle_rows(const TimedInput& input, Index rows);

}  // namespace thinbench
