// A band of rows whose runs are labelled on their own, and how bands are joined.
#pragma once

#include "regions/label_store.hpp"
#include "regions/run_engine.hpp"

namespace thinbench::detail {

/// Owns what one thread needs to label a band: 44 bytes a column, a few thousand, and labels.
class RunBand {
 public:
  explicit RunBand(Index width);

  /// Labels rows [first, last) of the image, at least one.
  void label(LabelRows label_rows, const ConstBitPlaneView& image, Index first, Index last);

  /// The labelled rows at the seams, and the labels.
  [[nodiscard]] RunRow& first_row() { return first_row_; }
  [[nodiscard]] RunRow& last_row() { return labelling_.above; }
  [[nodiscard]] LabelStore& labels() { return labels_; }

 private:
  AlignedArray<Key> memory_;
  RunRow first_row_;
  RunLabelling labelling_;
  LabelStore labels_;
};

/// Makes one region of all runs that touch across two rows labelled in the same tables.
void join_rows(LabelTables& tables, const RunRow& above, const RunRow& below);

/// Makes light runs of a row at the border of the image part of the outside.
void join_border(LabelTables& tables, const RunRow& row);

/// Appends the labels of `lower` to `labels` and joins the two rows at the seam. `lower`'s rows get
/// the new labels.
void join_bands(LabelStore& labels, const RunRow& last_above, RunBand& lower);

}  // namespace thinbench::detail
