// What a net has to learn: for each of the 256 neighbourhoods of a dark pixel, whether it stays.
#pragma once

#include <array>
#include <cstddef>

#include "thinbench/nets.hpp"
#include "thinning/rule_table.hpp"

namespace thinbench {

inline constexpr int kDescriptors = 256;

/// Entry k: a dark pixel whose neighbours n_i are the bits of k stays dark.
using StayTable = std::array<bool, kDescriptors>;

/// The table of the modified Naccache-Shinghal rule, from its expression.
inline StayTable stay_table_of_rule() {
  constexpr RuleTable kRule = make_rule_table<NaccacheShinghal, 0>();
  StayTable table{};
  for (std::size_t k = 0; k < kDescriptors; ++k) table[k] = kRule[kDescriptors + k] != 0;
  return table;
}

inline bool stays(const StayTable& table, int descriptor) {
  return table[static_cast<std::size_t>(descriptor)];
}

/// Neighbour n_i of a descriptor, 0 or 1.
constexpr int neighbour(int descriptor, int i) {
  return descriptor >> i & 1;
}

}  // namespace thinbench
