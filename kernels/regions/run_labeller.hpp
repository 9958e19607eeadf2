// Regions of a packed image: bands of rows, one per thread, are labelled separately and joined at
// the seams.
#pragma once

#include <deque>
#include <optional>

#include "core/thread_team.hpp"
#include "regions/contact_labeller.hpp"
#include "regions/label_store.hpp"
#include "regions/run_rows.hpp"

namespace thinbench::detail {

/// Labels a band and owns its memory: 44 bytes per column, a few kilobytes, and labels.
class RunBand {
 public:
  explicit RunBand(Index width);

  /// Labels rows [first, last) of the image; needs first < last. False if the kernel gave up.
  bool label(LabelRows label_rows, const ConstBitPlaneView& image, Index first, Index last);

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
  /// By one of the two kernels of `engine`. The team must outlive this.
  RunLabeller(const RunEngine& engine, bool with_holes, Isa isa, Index width, Index height,
              const ThreadTeam& team);

  /// Lists objects and, if asked for, holes. Throws std::bad_alloc.
  void find(const ConstBitPlaneView& image, Regions& found);

 private:
  /// False if a kernel gave up.
  bool label_bands(const ConstBitPlaneView& image);

  LabelRows label_rows_;
  bool with_holes_;
  Isa isa_;
  const ThreadTeam& team_;
  std::deque<RunBand> bands_;
  std::optional<ContactLabeller> contacts_;  // once they are needed
};

}  // namespace thinbench::detail
