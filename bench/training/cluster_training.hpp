// Training of the cluster of single-layer nets (section 3.3): as few nets as can be.
#pragma once

#include <vector>

#include "training/perceptron.hpp"

namespace thinbench {

struct ClusterTraining {
  int max_nets = kMaxClusterNets;
  bool small_integers = false;  // shrink the perceptron's whole numbers
};

/// One net, and why its run is as long as it can be.
struct TrainedRun {
  DescriptorRun run;
  IntegerNeuron neuron;  // correct on each descriptor of the run
  int epochs;
  Contradiction one_more;  // shows that run.last + 1 cannot be added; empty at 255
};

/// Cuts 0..255 into the longest runs that one neuron can learn, from descriptor 0 upwards, and
/// trains a neuron each. A part of a separable run is separable, so no cut has fewer runs. Every
/// neuron and every contradiction is checked. Throws std::runtime_error if that takes more than
/// `max_nets` nets.
[[nodiscard]] std::vector<TrainedRun> train_cluster(const KeepTable& table,
                                                    const ClusterTraining& training);

[[nodiscard]] ClusterWeights cluster_weights(const std::vector<TrainedRun>& runs);

}  // namespace thinbench
