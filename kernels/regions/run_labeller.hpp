// Regions of a packed image: bands of rows, one per thread, are labelled separately and joined at
// the seams.
#pragma once

#include <deque>
#include <memory>

#include "core/thread_team.hpp"
#include "regions/contact_labels.hpp"
#include "regions/label_store.hpp"
#include "regions/run_engine.hpp"

namespace thinbench::detail {

/// Labels a band and owns its memory: 44 bytes per column, a few kilobytes, and labels.
class RunBand {
 public:
  explicit RunBand(Index width);

  /// Labels rows [first, last) of the image; needs first < last. False if the kernel gave up.
  bool label(LabelRows label_rows, const ConstBitPlaneView& image, Index first, Index last,
             Index patience);

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

/// Finds regions by a kernel for runs that repeat from row to row. Where the kernel gives up, as on
/// noise, they are found by contacts of runs.
class RunLabeller {
 public:
  /// By one of the two kernels of `engine`.
  RunLabeller(const RunEngine& engine, bool with_holes, Isa isa, Index width, Index height,
              int threads);

  /// Objects and, if asked for, holes. Valid until the next call. Throws std::bad_alloc.
  RegionLists label(const ConstBitPlaneView& image);

 private:
  /// False if a kernel gave up.
  bool label_bands(const ConstBitPlaneView& image);
  RegionLists label_contacts(const ConstBitPlaneView& image);

  LabelRows label_rows_;
  bool with_holes_;
  Isa isa_;
  ThreadTeam team_;
  std::deque<RunBand> bands_;
  std::unique_ptr<ContactLabels> contacts_;  // once they are needed
};

/// Joins all background runs of a row at the image border with the outside.
void join_border(LabelTables& tables, const RunRow& row);

}  // namespace thinbench::detail
