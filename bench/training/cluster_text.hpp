// A trained cluster as text for people and for the compiler.
#pragma once

#include <string>
#include <vector>

#include "training/cluster_training.hpp"

namespace thinbench {

/// A table of the runs: weights, epochs, and the contradiction that ends each run.
[[nodiscard]] std::string cluster_markdown(const std::vector<TrainedRun>& runs);

/// A header that defines kTrainedCluster, with `command`, which made it, in its comment.
[[nodiscard]] std::string cluster_header(const ClusterWeights& weights, const std::string& command);

}  // namespace thinbench
