// All runs of a packed image, labelled and kept: for images that are made from regions.
//
// Cost: that of bitpacked_runs without sums, and 8 bytes kept for each run.
#pragma once

#include <vector>

#include "image/byte_image.hpp"
#include "regions/label_store.hpp"

namespace thinbench::detail {

/// All rows of runs of an image, one behind the other. Memory grows by need and is kept.
class KeptRows {
 public:
  explicit KeptRows(Index height) : ends_(static_cast<std::size_t>(height)) {}

  void clear() { used_ = 1; }

  /// Memory for a row of any kind, behind the rows kept. Rows handed out before may move.
  RunRow next_row(Index width);
  /// Keeps the row that next_row handed out.
  void keep(Index y, Index count);
  [[nodiscard]] RunRow row(Index y);

 private:
  struct Place {
    Index first = 0;
    Index count = 0;
  };

  RunRow row_at(Index first, Index count);
  void grow(Index capacity);

  AlignedArray<Key> keys_;
  AlignedArray<Label> labels_;
  Index capacity_ = 0;
  Index used_ = 1;
  std::vector<Place> ends_;
};

class LabelledRuns {
 public:
  LabelledRuns(Index width, Index height) : labels_(width), rows_(height) {}

  /// Labels all runs of an image, which has at least one row.
  void label(const ConstBitPlaneView& image);

  [[nodiscard]] RunRow row(Index y) { return rows_.row(y); }
  /// The root of each label of a colour; that of everything light that reaches the frame is 0.
  [[nodiscard]] const Label* roots(int colour) { return table(colour).parents; }
  [[nodiscard]] Label labels(int colour) { return table(colour).count; }
  /// A label of the contour round a hole, whose root is given; for other labels any contour's.
  [[nodiscard]] Label owner_of_hole(Label root) { return table(0).regions[root].enclosing_object; }

 private:
  [[nodiscard]] LabelTable& table(int colour) { return labels_.tables().of_colour[colour]; }
  void label_row(const ConstBitPlaneView& image, Index y);

  LabelStore labels_;
  KeptRows rows_;
};

/// Sets the pixels of run i, neither the first of a row nor the last.
void set_run(std::uint64_t* row, const RunRow& runs, Index i);

}  // namespace thinbench::detail
