// A plan owns what one variant of the chain needs for images of one size. This is the fast way from
// a grey picture to objects and holes; thinbench_localise.hpp has the convenient one.
#pragma once

#include "image/planes.hpp"
#include "edges/plan.hpp"
#include "regions/run_labeller.hpp"
#include "localise/outlined_objects.hpp"
#include "localise/variant.hpp"

namespace thinbench::detail {

struct LocaliseOptions {
  EdgeOperator edges = EdgeOperator::sobel;
  EdgeThresholds thresholds = {};
  int threads = 1;  // counts for threaded variants only
};

/// Runs one variant on images of one size. Not for use by two threads at once.
///
/// Nothing is unpacked on the way: two bits a pixel, 8 bytes a run of the edges and 52 bytes a
/// provisional label. Runs and labels grow by need: an image with more of them than any before
/// makes run() allocate, a second run on it does not.
class LocalisePlan {
 public:
  /// Throws std::invalid_argument where the variant cannot run here, the size is negative, a side
  /// is above 2^29 or the image above 2^32 pixels, a threshold is not in [0, 255] or threads is not
  /// in [1, kMaxThreads]; std::bad_alloc where memory is short.
  LocalisePlan(const LocaliseVariant& variant, Index width, Index height,
               const LocaliseOptions& options = {});

  /// Objects and holes, valid until the next run. `source` must have the size of the plan, nothing
  /// is checked here. Throws std::bad_alloc.
  RegionLists run(const ConstImageView& source);

  /// For tests: whether everything outside the rows of the plan's planes is still zero.
  [[nodiscard]] bool margins_are_zero() const;

 private:
  EdgePlan edges_;
  OutlinedObjects outlined_;
  BitPlane objects_;
  RunLabeller regions_;
};

}  // namespace thinbench::detail
