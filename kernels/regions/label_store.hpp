// Owns provisional labels and makes them into numbered regions.
#pragma once

#include <span>

#include "image/byte_image.hpp"
#include "regions/run_rows.hpp"

namespace thinbench::detail {

/// What was found: spans into the plan's memory, valid until it computes again.
struct RegionLists {
  std::span<const Region> objects;
  std::span<const Region> holes;
};

/// Memory for labels of both colours: 52 bytes a label. An image has at most height x
/// (width + 1) / 2 of them together, and few of those in practice, so memory grows by need, by
/// doubling, and is kept.
class LabelStore {
 public:
  /// Room for the labels of a first row of this width and some more.
  explicit LabelStore(Index width);

  [[nodiscard]] LabelTables& tables() { return tables_; }
  /// Forgets all labels but label 0 of the background.
  void clear();
  /// Makes room for `labels` more of each colour. Throws std::bad_alloc.
  void make_room(Index labels);
  /// Appends the labels of another part of the image, below all of this. Label 0 of its background
  /// becomes this one's; its label i of colour c becomes i + the result's element c, except that.
  struct Offsets {
    Label of_colour[2];
  };
  Offsets append(const LabelTables& other);
  /// Adds up the labels of each region and numbers the regions; `parents` then hold, for each
  /// label, its region's position: in objects, or in holes plus one (0 is no hole).
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
