// Regions of a packed image: bands of rows, one a thread, labelled on their own and joined at the
// seams.
#pragma once

#include <deque>

#include "thinbench/isa.hpp"
#include "image/thread_team.hpp"
#include "regions/run_band.hpp"

namespace thinbench::detail {

class RunLabeller {
 public:
  RunLabeller(LabelRows label_rows, Index width, Index height, int threads);

  /// Objects and, if the kernel looks at light runs, holes; valid until the next call. Throws
  /// std::bad_alloc.
  RegionLists label(const ConstBitPlaneView& image);

 private:
  LabelRows label_rows_;
  ThreadTeam team_;
  std::deque<RunBand> bands_;
};

}  // namespace thinbench::detail
