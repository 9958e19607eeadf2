// The state of the graph of a skeleton.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "core/packing.hpp"
#include "core/planes.hpp"
#include "core/thread_team.hpp"
#include "core/variant.hpp"
#include "graph/node_pixels.hpp"
#include "graph/walker.hpp"

namespace thinbench::detail {

struct GraphParameters {};
using GraphSetting = Setting<GraphParameters>;

/// Owns three bits and four bytes per pixel, and the graph. Threads share the search for node
/// pixels; one walks.
class GraphState {
 public:
  using Parameters = GraphParameters;

  static void check(const GraphParameters&, Index width, Index height) {
    require_label_size(width, height);
  }

  GraphState(const GraphKernels& kernels, const GraphSetting& setting);

  /// May be moved from; else valid until the next call.
  Graph& run(const ConstImageView& source);
  /// Writes the pruned image, after all that may need memory; returns its graph.
  Graph prune(const ConstImageView& source, const Pruning& pruning, const ImageView& destination);

 private:
  Graph& walk();

  GraphKernels kernels_;
  const PlaneConversion<std::uint64_t>& conversion_;
  ThreadTeam team_;
  BitPlane image_;
  BitPlane nodes_;
  BitPlane lines_;
  GraphWalker walker_;
};

using GraphOperation = Operation<std::monostate, GraphState>;

[[nodiscard]] const GraphOperation& graph_operation();

}  // namespace thinbench::detail
