// What is compiled from the circuits of built-in rules, per ISA.
#pragma once

#include "scan/bound_rule.hpp"

namespace thinbench::detail {

/// One entry per built-in rule.
template <class T>
struct ByRule {
  T entries[kRules.size()] = {};

  constexpr const T& operator[](BuiltInRule rule) const {
    return entries[static_cast<std::size_t>(rule)];
  }
  constexpr T& operator[](BuiltInRule rule) { return entries[static_cast<std::size_t>(rule)]; }
};

/// By sub-iteration. Those of rules that are no function of a neighbourhood are nullptr.
using ScanFunctions = std::array<ScanFunction, kMaxSubIterations>;
using TilePasses = std::array<TilePass, kMaxSubIterations>;

/// nullptr for layouts that the ISA does not have. There are none for words: tiles and rows are
/// faster everywhere.
struct BuiltInScans {
  Index register_elements;
  ByRule<ScanFunctions> row;
  ByRule<RepeatFunction> lanes[3];  // of 32, 64 and 128 pixels
};

struct BuiltInTilePasses {
  ByRule<TilePasses> by_rule;
  TilePass by_scan;  // calls a scan function for each tile
};

}  // namespace thinbench::detail
