// The graph of a skeleton, in plain code.
#pragma once

#include "thinbench/graph.hpp"

namespace thinbench::reference {

/// Nodes by flood filling, edges by walking, pixel after pixel; see thinbench/graph.hpp for what
/// they are and for their order.
[[nodiscard]] Graph skeleton_graph(ConstImageView skeleton);

}  // namespace thinbench::reference
