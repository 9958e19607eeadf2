// One variant of the paper's whole chain at work: edges as packed bits, the objects that they
// outline, and the regions of these.
#pragma once

#include <vector>

#include "dispatch/variant.hpp"
#include "edges/state.hpp"
#include "image/planes.hpp"
#include "localise/outlined_objects.hpp"
#include "regions/run_labeller.hpp"

namespace thinbench::detail {

struct LocaliseSetting {
  EdgeOperator op;
  EdgeThresholds thresholds;
  Isa isa;
  Index width;
  Index height;
  int threads;
};

/// Nothing is unpacked on the way: two bits per pixel, 8 bytes per run of the edges and 52 bytes per
/// provisional label. Runs and labels grow by need: an image with more of them than any before makes
/// run() allocate, a second run on it does not. Threads share edges and regions; what the edges
/// outline is found on one.
class LocaliseState {
 public:
  using Setting = LocaliseSetting;

  LocaliseState(LabelRows label_rows, const LocaliseSetting& setting);

  /// Objects and holes, valid until the next run. `source` has the size of the setting.
  RegionLists run(const ConstImageView& source);

 private:
  PackedEdges edges_;
  OutlinedObjects outlined_;
  BitPlane objects_;
  RunLabeller regions_;
};

using LocaliseVariant = Variant<LocaliseState>;

/// Each names the technique by which the regions are found.
[[nodiscard]] std::vector<LocaliseVariant> localise_variants();

}  // namespace thinbench::detail
