// The truth table of a rule: its expression evaluated on all 512 neighbourhoods, 64 at a time.
#pragma once

#include <array>
#include <cstdint>

#include "rules/parallel_rules.hpp"
#include "thinbench/window_table.hpp"

namespace thinbench::detail {

/// Word `word` of the values of input `variable`: bit i belongs to neighbourhood 64 word + i.
constexpr std::uint64_t counting_pattern(int variable, int word) {
  constexpr std::uint64_t low[6] = {0xAAAAAAAAAAAAAAAA, 0xCCCCCCCCCCCCCCCC, 0xF0F0F0F0F0F0F0F0,
                                    0xFF00FF00FF00FF00, 0xFFFF0000FFFF0000, 0xFFFFFFFF00000000};
  if (variable < 6) return low[variable];
  return (word >> (variable - 6) & 1) != 0 ? ~std::uint64_t{0} : 0;
}

/// New pixels by k + 256 p, with the descriptor k.
using RuleTable = std::array<std::uint8_t, 512>;

/// k + 256 p of a window of WindowTable.
constexpr std::size_t descriptor_of(std::size_t window) {
  constexpr int pixel_of[9] = {5, 2, 1, 0, 3, 6, 7, 8, 4};  // n0 ... n7, p
  std::size_t descriptor = 0;
  for (std::size_t i = 0; i < 9; ++i) descriptor |= (window >> pixel_of[i] & 1) << i;
  return descriptor;
}

template <class Rule, int sub>
constexpr RuleTable make_rule_table() {
  RuleTable table{};
  for (int word = 0; word < 8; ++word) {
    const auto input = [word](int variable) { return counting_pattern(variable, word); };
    const Neighbourhood<std::uint64_t> n = {input(8), input(0), input(1), input(2), input(3),
                                            input(4), input(5), input(6), input(7)};
    const std::uint64_t next = Rule::template next<sub>(n);
    for (int bit = 0; bit < 64; ++bit) {
      table[std::size_t{64} * static_cast<std::size_t>(word) + static_cast<std::size_t>(bit)] =
          next >> bit & 1;
    }
  }
  return table;
}

/// The same as rules given by tables have it.
template <class Rule, int sub>
WindowTable make_window_table_of() {
  static constexpr RuleTable kTable = make_rule_table<Rule, sub>();
  return make_window_table([](std::size_t window) { return kTable[descriptor_of(window)] != 0; });
}

}  // namespace thinbench::detail
