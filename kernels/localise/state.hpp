// The state of the paper's whole pipeline: edges as packed bits, the objects that they outline, and
// the regions of these objects.
#pragma once

#include <vector>

#include "core/planes.hpp"
#include "core/variant.hpp"
#include "edges/state.hpp"
#include "localise/outlined_objects.hpp"
#include "regions/run_labeller.hpp"

namespace thinbench::detail {

using LocaliseSetting = Setting<EdgeParameters>;

/// Everything stays packed: two bits per pixel, 8 bytes per run of the edges and 52 bytes per
/// provisional label. Memory for runs and labels grows on demand: run() allocates only when an
/// image has more of them than all before. Threads share edges and regions; outlined objects are
/// found on one thread.
class LocaliseState {
 public:
  using Parameters = EdgeParameters;

  static void check(const EdgeParameters& parameters, Index width, Index height) {
    require_regions_size(width, height);
    require_thresholds(parameters.thresholds);
  }

  LocaliseState(const RunEngine& engine, const LocaliseSetting& setting);

  /// Objects and holes, valid until the next run. `source` must have the size of the setting.
  RegionLists run(const ConstImageView& source);

  /// The image of the objects, valid as long.
  [[nodiscard]] ConstBitPlaneView objects() const { return objects_.view(); }

 private:
  PackedEdges edges_;
  OutlinedObjects outlined_;
  BitPlane objects_;
  RunLabeller regions_;
};

using LocaliseVariant = Variant<LocaliseState>;
using LocaliseOperation = Operation<EdgeOperator, LocaliseState>;

/// Its variants are named after the technique that finds the regions.
[[nodiscard]] const LocaliseOperation& localise_operation();

}  // namespace thinbench::detail
