#include "regions/label_store.hpp"

#include <algorithm>

namespace thinbench::detail {
namespace {

/// Lists the regions of roots from label `first` on, after moving them to the front in this order.
/// A parent never exceeds its label, so its number is known when the label is visited.
void list_regions(const LabelTable& table, Label first, std::vector<Region>& regions) {
  Label count = first;
  for (Label label = first; label < table.count; ++label) {
    Label& parent = table.parents[label];
    if (parent == label) {
      table.regions[count] = table.regions[label];
      parent = count++;
    } else {
      parent = table.parents[parent];
      add_region(table.regions[parent], table.regions[label]);
    }
  }
  regions.assign(table.regions + first, table.regions + count);
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

void LabelStore::list_objects(std::vector<Region>& objects) {
  list_regions(tables_.of_colour[1], 0, objects);
}

void LabelStore::list_holes(std::vector<Region>& holes) {
  list_regions(tables_.of_colour[0], 1, holes);
  const Label* const objects = tables_.of_colour[1].parents;
  for (Region& hole : holes) hole.enclosing_object = objects[hole.enclosing_object] + 1;
}

}  // namespace thinbench::detail
