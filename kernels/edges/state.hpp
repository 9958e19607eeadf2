// The states of the edge operators: edges as bytes or as packed bits.
#pragma once

#include <memory>
#include <vector>

#include "core/planes.hpp"
#include "core/thread_team.hpp"
#include "core/variant.hpp"
#include "edges/kernels.hpp"

namespace thinbench::detail {

struct EdgeParameters {
  EdgeOperator op;
  EdgeThresholds thresholds;
};
using EdgeSetting = Setting<EdgeParameters>;

/// Rejects a threshold outside [0, 255].
void require_thresholds(const EdgeThresholds& thresholds);

/// Edges as bytes. Threads share bands of rows.
class EdgeState {
 public:
  using Parameters = EdgeParameters;

  static void check(const EdgeParameters& parameters, Index width, Index height) {
    require_max_pixels(width, height);
    require_thresholds(parameters.thresholds);
  }

  EdgeState(EdgesToBytes kernel, const EdgeSetting& setting);

  /// Both views must have the size of the setting and must not overlap.
  void run(const ConstImageView& source, const ImageView& destination);

 private:
  EdgesToBytes kernel_;
  EdgeThresholds thresholds_;
  ThreadTeam team_;
};

using EdgeVariant = Variant<EdgeState>;
using EdgeVariants = VariantList<EdgeState>;
using EdgeOperation = Operation<EdgeOperator, EdgeState>;

/// They live as long as the program.
[[nodiscard]] std::span<const EdgeOperation> edge_operations();
[[nodiscard]] const EdgeOperation& operation_of(EdgeOperator op);

/// Edges as packed bits. Threads share bands of rows.
class PackedEdges {
 public:
  explicit PackedEdges(const EdgeSetting& setting);

  /// Valid until the next call.
  ConstBitPlaneView run(const ConstImageView& source);

 private:
  EdgesToBits kernel_;
  EdgeThresholds thresholds_;
  ThreadTeam team_;
  BitPlane bits_;
};

}  // namespace thinbench::detail
