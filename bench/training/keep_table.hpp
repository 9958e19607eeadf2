// What a net has to learn: for each of the 256 neighbourhoods of a foreground pixel, whether the
// pixel is kept.
#pragma once

#include <array>
#include <cstddef>

#include "rules/rule_table.hpp"
#include "thinbench/nets.hpp"

namespace thinbench {

inline constexpr int kDescriptors = 256;

/// Entry k: a foreground pixel whose neighbours n_i are the bits of k is kept.
using KeepTable = std::array<bool, kDescriptors>;

/// The table of the modified Naccache-Shinghal rule, from its expression.
inline KeepTable keep_table_of_rule() {
  constexpr detail::RuleTable kRule = detail::make_rule_table<detail::NaccacheShinghal, 0>();
  KeepTable table{};
  for (std::size_t k = 0; k < kDescriptors; ++k) table[k] = kRule[kDescriptors + k] != 0;
  return table;
}

inline bool keeps(const KeepTable& table, int descriptor) {
  return table[static_cast<std::size_t>(descriptor)];
}

/// Neighbour n_i of a descriptor, 0 or 1.
constexpr int neighbour(int descriptor, int i) {
  return descriptor >> i & 1;
}

}  // namespace thinbench
