// The state of the graph of a skeleton.
#pragma once

#include <memory>
#include <vector>

#include "dispatch/variant.hpp"
#include "graph/node_pixels.hpp"
#include "graph/walker.hpp"
#include "image/packing.hpp"
#include "image/planes.hpp"
#include "image/thread_team.hpp"

namespace thinbench::detail {

struct GraphSetting {
  Isa isa;
  Index width;
  Index height;
  int threads;
};

/// Owns three bits and four bytes per pixel, and the graph. Threads share the search for node
/// pixels; one walks.
class GraphState {
 public:
  using Setting = GraphSetting;

  GraphState(const GraphKernels& kernels, const GraphSetting& setting);

  void load(const ConstImageView& source);
  /// Valid until the next call.
  const Graph& compute();

 private:
  GraphKernels kernels_;
  const PlaneConversion<std::uint64_t>& conversion_;
  ThreadTeam team_;
  BitPlane image_;
  BitPlane nodes_;
  BitPlane lines_;
  GraphWalker walker_;
};

using GraphVariant = Variant<GraphState>;
using GraphVariants = VariantList<GraphState>;

[[nodiscard]] std::vector<GraphVariant> graph_variants();

}  // namespace thinbench::detail
