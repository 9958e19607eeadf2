// Owns provisional labels and turns them into numbered regions.
#pragma once

#include "core/byte_image.hpp"
#include "regions/label_table.hpp"
#include "thinbench/regions.hpp"

namespace thinbench::detail {

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
  /// Lists the objects, each the sum of its labels. Afterwards `parents[label]` is the index of the
  /// label's object.
  void list_objects(std::vector<Region>& objects);
  /// Lists the holes, after list_objects(). Afterwards `parents[label]` is the index of the label's
  /// hole plus one, or 0.
  void list_holes(std::vector<Region>& holes);

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
