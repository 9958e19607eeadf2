// "A cluster of 12 single layer neural networks" (section 3.3): how many nets the rule needs.
#pragma once

#include <vector>

#include "experiments/report.hpp"
#include "training/cluster_training.hpp"

namespace thinbench {

/// The rule's cluster, trained afresh: as few nets as can be, since each run is as long as it can
/// be and a part of a separable run is separable.
[[nodiscard]] std::vector<TrainedRun> run_cluster_runs();

[[nodiscard]] ExperimentReport cluster_runs_report(const std::vector<TrainedRun>& runs);

}  // namespace thinbench
