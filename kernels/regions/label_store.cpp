#include "regions/label_store.hpp"

#include <algorithm>

namespace thinbench::detail {
namespace {

void add_region(Region& sum, const Region& part) {
  sum.area += part.area;
  sum.sum_x += part.sum_x;
  sum.sum_y += part.sum_y;
  sum.left = std::min(sum.left, part.left);
  sum.right = std::max(sum.right, part.right);
  sum.bottom = std::max(sum.bottom, part.bottom);
}

/// Moves regions to the front in the order of their roots. A parent never exceeds its label, so its
/// index is known when the label is visited.
Label gather_regions(const LabelTable& table) {
  Label count = 0;
  for (Label label = 0; label < table.count; ++label) {
    Label& parent = table.parents[label];
    if (parent == label) {
      table.regions[count] = table.regions[label];
      parent = count++;
    } else {
      parent = table.parents[parent];
      add_region(table.regions[parent], table.regions[label]);
    }
  }
  return count;
}

}  // namespace

LabelStore::LabelStore(Index width) {
  make_room((width + 1) / 2 + 1000);
  clear();
}

void LabelStore::clear() {
  for (LabelTable& table : tables_.of_colour) table.count = 0;
  new_label(tables_.of_colour[0], 0, 0);
}

void LabelStore::make_room(Index labels) {
  for (int colour = 0; colour < 2; ++colour) {
    const LabelTable& table = tables_.of_colour[colour];
    const Label needed = table.count + static_cast<Label>(labels) + 1;
    const Label doubled = table.capacity + std::min(table.capacity, ~table.capacity);  // saturates
    if (needed > table.capacity) grow(colour, std::max(needed, doubled));
  }
}

void LabelStore::grow(int colour, Label capacity) {
  Memory larger = {make_uninitialised<Label>(capacity), make_uninitialised<Region>(capacity)};
  LabelTable& table = tables_.of_colour[colour];
  std::copy_n(table.parents, table.count, larger.parents.get());
  std::copy_n(table.regions, table.count, larger.regions.get());
  memory_[colour] = std::move(larger);
  table.parents = memory_[colour].parents.get();
  table.regions = memory_[colour].regions.get();
  table.capacity = capacity;
}

LabelStore::Offsets LabelStore::append(const LabelTables& other) {
  make_room(std::max(other.of_colour[0].count, other.of_colour[1].count));
  Offsets offsets{};
  for (int colour = 0; colour < 2; ++colour) {
    LabelTable& table = tables_.of_colour[colour];
    const LabelTable& part = other.of_colour[colour];
    const Label shared = colour == 0 ? 1 : 0;  // both tables have the outside
    const Label offset = table.count - shared;
    for (Label label = shared; label < part.count; ++label) {
      const Label parent = part.parents[label];
      table.parents[offset + label] = parent < shared ? parent : parent + offset;
      table.regions[offset + label] = part.regions[label];
    }
    table.count += part.count - shared;
    offsets.of_colour[colour] = offset;
  }
  LabelTable& background = tables_.of_colour[0];  // enclosing objects are foreground labels
  for (Label label = offsets.of_colour[0] + 1; label < background.count; ++label) {
    background.regions[label].enclosing_object += offsets.of_colour[1];
  }
  return offsets;
}

RegionLists LabelStore::number_regions() {
  const LabelTable& background = tables_.of_colour[0];
  const LabelTable& objects = tables_.of_colour[1];
  const Label object_count = gather_regions(objects);
  const Label background_count = gather_regions(background);
  for (Label hole = 1; hole < background_count; ++hole) {
    Label& enclosing_object = background.regions[hole].enclosing_object;
    enclosing_object = objects.parents[enclosing_object] + 1;
  }
  return {{objects.regions, object_count}, {background.regions + 1, background_count - 1}};
}

}  // namespace thinbench::detail
