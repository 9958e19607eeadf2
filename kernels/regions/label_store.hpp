// Owns provisional labels and turns them into numbered regions.
#pragma once

#include <span>

#include "image/byte_image.hpp"
#include "regions/label_table.hpp"

namespace thinbench::detail {

/// Spans into the state's memory, valid until its next computation.
struct RegionLists {
  std::span<const Region> objects;
  std::span<const Region> holes;
};

/// Memory for labels of both colours: 52 bytes per label. An image has at most height x
/// (width + 1) / 2 of them together and usually few, so memory grows on demand, by doubling, and is
/// reused.
class LabelStore {
 public:
  /// With room for the labels of the first row and some more.
  explicit LabelStore(Index width);

  [[nodiscard]] LabelTables& tables() { return tables_; }
  /// Removes all labels but label 0 of the background.
  void clear();
  /// Makes room for `labels` more of each colour. Throws std::bad_alloc.
  void make_room(Index labels);

  struct Offsets {
    Label of_colour[2];
  };
  /// Appends the labels of another part of the image, below all of this one. Its label i of colour
  /// c becomes i + the result's element c, but label 0 of the background stays 0.
  Offsets append(const LabelTables& other);
  /// Sums up the labels of each region and numbers the regions. `parents` then hold, per label, the
  /// index of its region: in objects, or in holes plus one (0 is no hole).
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
