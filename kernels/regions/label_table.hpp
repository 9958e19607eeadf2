// Provisional labels: union-find forests and sums per label. Plain structs and always-inlined
// functions, safe to include in ISA files.
#pragma once

#include "core/plane_view.hpp"
#include "core/union_find.hpp"
#include "thinbench/region.hpp"

namespace thinbench::detail {

/// `parents[label] <= label`, so a root is the first label of its region, and the order of roots is
/// the raster order of first pixels.
struct LabelTable {
  Label* parents = nullptr;
  Region* regions = nullptr;
  Label count = 0;
  Label capacity = 0;
};

/// [0] is background, whose label 0 is everything connected to the image border; [1] is foreground.
struct LabelTables {
  LabelTable of_colour[2];
};

/// Adds a label whose first pixel is in row y. The table must have room.
[[gnu::always_inline]] inline Label new_label(LabelTable& table, Index y, Label enclosing_object) {
  const Label label = table.count++;
  const auto row = static_cast<std::int32_t>(y);
  table.parents[label] = label;
  table.regions[label] = {0, 0, 0, INT32_MAX, row, -1, row, enclosing_object};
  return label;
}

/// Adds pixels [begin, end) of row y; y must not decrease between calls.
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

/// Adds a part of the same region; what encloses it remains.
[[gnu::always_inline]] inline void add_region(Region& sum, const Region& part) {
  sum.area += part.area;
  sum.sum_x += part.sum_x;
  sum.sum_y += part.sum_y;
  if (part.left < sum.left) sum.left = part.left;
  if (part.top < sum.top) sum.top = part.top;
  if (part.right > sum.right) sum.right = part.right;
  if (part.bottom > sum.bottom) sum.bottom = part.bottom;
}

/// Whether both tables have room for the labels of one more row.
[[gnu::always_inline]] inline bool has_room(const LabelTables& tables, Index width) {
  const auto needed = static_cast<Label>((width + 1) / 2);
  return tables.of_colour[0].capacity - tables.of_colour[0].count >= needed &&
         tables.of_colour[1].capacity - tables.of_colour[1].count >= needed;
}

}  // namespace thinbench::detail
