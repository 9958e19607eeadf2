// All runs of a packed image with their labels, for operations that write images.
//
// Cost: that of bitpacked_runs, for label() without sums, plus 8 bytes stored per run.
#pragma once

#include <vector>

#include "core/byte_image.hpp"
#include "regions/label_store.hpp"
#include "regions/run_rows.hpp"

namespace thinbench::detail {

/// The runs of all rows, contiguous. Memory grows on demand and is reused.
class RunStore {
 public:
  explicit RunStore(Index height) : rows_(static_cast<std::size_t>(height)) {}

  void clear() { used_ = 1; }
  /// Memory for one more row, after the stored rows. Invalidates rows returned before.
  RunRow next_row(Index width);
  /// Keeps the contents of the last next_row() as row y, with `count` keys.
  void store(Index y, Index count);
  [[nodiscard]] RunRow row(Index y);

 private:
  struct Place {
    Index first = 0;
    Index count = 0;
  };

  RunRow row_at(const Place& place);
  void grow(Index capacity);

  AlignedArray<Key> keys_;
  AlignedArray<Label> labels_;
  Index capacity_ = 0;
  Index used_ = 1;
  std::vector<Place> rows_;
};

class LabelledRuns {
 public:
  LabelledRuns(Index width, Index height) : labels_(width), rows_(height) {}

  /// Labels all runs of an image of at least one row.
  void label(const ConstBitPlaneView& image);
  /// The same, and numbers the regions: afterwards the root of a foreground label is the index of
  /// its object, and that of a background label is the index of its hole plus one (0: no hole).
  RegionLists label_and_number(const ConstBitPlaneView& image);

  [[nodiscard]] RunRow row(Index y) { return rows_.row(y); }
  /// The root of each label of a colour; background connected to the border has root 0.
  [[nodiscard]] const Label* roots(int colour) { return table(colour).parents; }
  [[nodiscard]] Label labels(int colour) { return table(colour).count; }
  /// For the root of a hole, a label of the contour around it; for other labels, of any contour.
  [[nodiscard]] Label contour_of_hole(Label root) {
    return table(0).regions[root].enclosing_object;
  }

 private:
  [[nodiscard]] LabelTable& table(int colour) { return labels_.tables().of_colour[colour]; }
  template <bool with_sums>
  void label_rows(const ConstBitPlaneView& image);

  LabelStore labels_;
  RunStore rows_;
};

/// Sets the pixels of run i, which must not be the first or last of its row.
void set_run(std::uint64_t* row, const RunRow& runs, Index i);

}  // namespace thinbench::detail
