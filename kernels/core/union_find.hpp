// Sets of numbers as trees, joined at their roots; safe to include in ISA files.
#pragma once

#include <cstdint>

namespace thinbench::detail {

/// What stands for a set is its lowest number, the root: `parents[label] <= label`.
using Label = std::uint32_t;

[[gnu::always_inline]] inline Label find_root(Label* parents, Label label) {
  while (parents[label] != label) {
    parents[label] = parents[parents[label]];
    label = parents[label];
  }
  return label;
}

/// Merges the regions of two labels and returns the root.
[[gnu::always_inline]] inline Label unite(Label* parents, Label a, Label b) {
  if (a == b) return a;
  const Label root_a = find_root(parents, a);
  const Label root_b = find_root(parents, b);
  const Label root = root_a < root_b ? root_a : root_b;
  parents[root_a < root_b ? root_b : root_a] = root;
  return root;
}

}  // namespace thinbench::detail
