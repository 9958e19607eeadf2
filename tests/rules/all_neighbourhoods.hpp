// All 512 neighbourhoods of 3 x 3 pixels.
#pragma once

#include <cstdint>

#include "rules/rule_table.hpp"

namespace thinbench::detail {

/// Neighbourhoods 64 * word to 64 * word + 63, one per bit. Bit i of a number is n_i, bit 8 is p.
inline Neighbourhood<std::uint64_t> neighbourhoods_of_word(int word) {
  const auto input = [word](int variable) { return counting_pattern(variable, word); };
  return {input(8), input(0), input(1), input(2), input(3), input(4), input(5), input(6), input(7)};
}

}  // namespace thinbench::detail
