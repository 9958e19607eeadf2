// Provisional labels of one colour: a union-find forest and what was summed for each label. For
// every file, ISA files included: a plain struct and functions that are always inlined.
#pragma once

#include "image/plane_view.hpp"
#include "thinbench/region.hpp"

namespace thinbench::detail {

using Label = std::uint32_t;

inline constexpr std::int32_t kNoColumn = INT32_MAX;

/// `parents[label]` is never above `label`, so a root is the earliest label of its region, and the
/// order of roots is the raster order of first pixels.
struct LabelTable {
  Label* parents = nullptr;
  Region* regions = nullptr;
  Label count = 0;
  Label capacity = 0;
};

[[gnu::always_inline]] inline Label find_root(Label* parents, Label label) {
  while (parents[label] != label) {
    parents[label] = parents[parents[label]];
    label = parents[label];
  }
  return label;
}

/// Makes two labels one region and returns its root.
[[gnu::always_inline]] inline Label unite(Label* parents, Label a, Label b) {
  if (a == b) return a;
  const Label root_a = find_root(parents, a);
  const Label root_b = find_root(parents, b);
  const Label root = root_a < root_b ? root_a : root_b;
  parents[root_a < root_b ? root_b : root_a] = root;
  return root;
}

/// A label whose first pixel is in row y. The table must have room.
[[gnu::always_inline]] inline Label new_label(LabelTable& table, Index y, Label enclosing_object) {
  const Label label = table.count++;
  const auto row = static_cast<std::int32_t>(y);
  table.parents[label] = label;
  table.regions[label] = {0, 0, 0, kNoColumn, row, -1, row, enclosing_object};
  return label;
}

/// Adds pixels [begin, end) of row y, the lowest row so far.
[[gnu::always_inline]] inline void add_run(Region& region, std::int64_t begin, std::int64_t end,
                                           Index y) {
  const std::int64_t length = end - begin;
  region.area += length;
  region.sum_x += length * (begin + end - 1) / 2;
  region.sum_y += length * y;
  if (begin < region.left) region.left = static_cast<std::int32_t>(begin);
  if (end > region.right) region.right = static_cast<std::int32_t>(end - 1);
  region.bottom = static_cast<std::int32_t>(y);
}

}  // namespace thinbench::detail
