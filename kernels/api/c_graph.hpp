// What a handle of a graph holds.
#pragma once

#include <cstdint>
#include <vector>

#include "api/c_arguments.hpp"
#include "thinbench/graph.hpp"

struct thinbench_graph : thinbench::Graph {
  std::vector<std::int32_t> labels;  // of the nodes; empty without labels
};

namespace thinbench::detail {

/// For a skeleton of this size.
[[nodiscard]] Pruning pruning_of(const thinbench_pruning* pruning, Index width, Index height);

}  // namespace thinbench::detail
