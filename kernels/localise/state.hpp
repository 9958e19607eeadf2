// The state of the paper's whole pipeline: edges as packed bits, the objects that they outline, and
// the regions of these objects.
#pragma once

#include "core/packing.hpp"
#include "core/planes.hpp"
#include "core/variant.hpp"
#include "edges/state.hpp"
#include "localise/outlined_objects.hpp"
#include "regions/run_labeller.hpp"

namespace thinbench::detail {

using LocaliseSetting = Setting<EdgeParameters>;

/// Everything stays packed: four bits per pixel, and 52 bytes per provisional label. Memory for
/// runs and labels grows on demand: run() allocates only when an image has more of them than all
/// before. Threads share edges and regions; outlined objects are found on one thread.
class LocaliseState {
 public:
  using Parameters = EdgeParameters;

  static void check(const EdgeParameters& parameters, Index width, Index height) {
    require_regions_size(width, height);
    require_thresholds(parameters.thresholds);
  }

  explicit LocaliseState(const LocaliseSetting& setting);

  /// Lists objects and holes. `source` must have the size of the setting.
  void run(const ConstImageView& source, Regions& found);

  /// Writes the image of the objects that the last run found.
  void write_objects(const ImageView& image) const { conversion_.write(objects_.view(), image); }

 private:
  ThreadTeam team_;
  const PlaneConversion<std::uint64_t>& conversion_;
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
