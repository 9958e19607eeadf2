// Owns provisional labels and turns them into numbered regions.
#pragma once

#include <span>

#include "core/byte_image.hpp"
#include "regions/label_table.hpp"

namespace thinbench::detail {

/// Spans into the state's memory, valid until its next computation.
struct RegionLists {
  std::span<const Region> objects;
  std::span<const Region> holes;
};

/// Memory for labels of both colours: 52 bytes per label. An image has at most
/// height * (width + 1) / 2 labels and usually few, so memory grows on demand, by doubling, and is
/// reused.
class LabelStore {
 public:
  /// Makes room for the labels of the first row and some more.
  explicit LabelStore(Index width);

  [[nodiscard]] LabelTables& tables() { return tables_; }
  /// Removes all labels except label 0 of the background.
  void clear();
  /// Makes room for `labels` more labels of each colour. Throws std::bad_alloc.
  void make_room(Index labels);

  struct Offsets {
    Label of_colour[2];
  };
  /// Appends the labels of a part of the image below this one. Its label i of colour c becomes
  /// i + of_colour[c], except that label 0 of the background remains 0.
  Offsets append(const LabelTables& other);
  /// Sums the labels of each region and numbers the regions. Afterwards `parents[label]` is the
  /// index of the label's object, or the index of its hole plus one (0: not a hole).
  RegionLists number_regions();

 private:
  struct Memory {
    AlignedArray<Label> parents;
    AlignedArray<Region> regions;
  };
  void grow(int colour, Label capacity);

  LabelTables tables_;
  Memory memory_[2];
};

}  // namespace thinbench::detail
