// The states of the edge operators: edges as bytes or as packed bits.
#pragma once

#include <memory>
#include <vector>

#include "dispatch/variant.hpp"
#include "edges/kernels.hpp"
#include "image/planes.hpp"
#include "image/thread_team.hpp"

namespace thinbench::detail {

struct EdgeSetting {
  EdgeOperator op;
  EdgeThresholds thresholds;
  Isa isa;
  Index width;
  Index height;
  int threads;
};

/// Edges as bytes. Threads share bands of rows.
class EdgeState {
 public:
  using Setting = EdgeSetting;

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

[[nodiscard]] std::vector<EdgeVariant> edge_variants(EdgeOperator op);

/// Throws std::invalid_argument for a threshold outside [0, 255].
void check_thresholds(const EdgeThresholds& thresholds);

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
