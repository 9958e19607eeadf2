// The state of the paper's whole chain: edges as packed bits, the objects that they outline, and
// the regions of these.
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

/// Nothing is unpacked on the way: two bits per pixel, 8 bytes per run of the edges and 52 bytes
/// per provisional label. Memory for runs and labels grows on demand: run() allocates where an
/// image has more of them than any before, but not in a second run on it. Threads share edges and
/// regions; outlined objects are found on one.
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

/// Named after the technique that finds the regions.
[[nodiscard]] std::vector<LocaliseVariant> localise_variants();

}  // namespace thinbench::detail
