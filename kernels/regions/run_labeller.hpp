// Regions of a packed image: bands of rows, one per thread, are labelled separately and joined at
// the seams.
#pragma once

#include <deque>

#include "core/thread_team.hpp"
#include "regions/label_store.hpp"
#include "regions/run_engine.hpp"

namespace thinbench::detail {

/// Labels a band and owns its memory: 44 bytes per column, a few kilobytes, and labels.
class RunBand {
 public:
  explicit RunBand(Index width);

  /// Labels rows [first, last) of the image; needs first < last.
  void label(LabelRows label_rows, const ConstBitPlaneView& image, Index first, Index last);

  // Results: the rows at the seams, and the labels.
  [[nodiscard]] RunRow& first_row() { return first_row_; }
  [[nodiscard]] RunRow& last_row() { return labelling_.above; }
  [[nodiscard]] LabelStore& labels() { return labels_; }

 private:
  AlignedArray<Key> memory_;
  RunRow first_row_;
  RunLabelling labelling_;
  LabelStore labels_;
};

class RunLabeller {
 public:
  RunLabeller(LabelRows label_rows, Index width, Index height, int threads);

  /// Objects and, if the kernel labels background runs, holes. Valid until the next call. Throws
  /// std::bad_alloc.
  RegionLists label(const ConstBitPlaneView& image);

 private:
  LabelRows label_rows_;
  ThreadTeam team_;
  std::deque<RunBand> bands_;
};

/// Joins all background runs of a row at the image border with the outside.
void join_border(LabelTables& tables, const RunRow& row);

}  // namespace thinbench::detail
