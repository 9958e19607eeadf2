// The cluster of single-layer nets (section 3.3): which descriptors one neuron can learn, and
// training with as few nets as possible.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "training/keep_table.hpp"

namespace thinbench {

/// The descriptors from `first` to `last`, both included.
struct DescriptorRun {
  int first;
  int last;
};

/// A vector, and how many times it is taken.
struct WeightedDescriptor {
  int descriptor;
  std::int64_t times;
};

/// Why no neuron answers correctly on a run: the kept vectors, each taken `times` times,
/// have the same sum and number as the removed ones. A neuron's net input, summed over the first,
/// would have to be at least 0 and, summed over the second, below 0: but the two sums are equal.
using Contradiction = std::vector<WeightedDescriptor>;

/// A contradiction within the run; empty if there is none, and then a neuron can learn the run
/// (Farkas). Exact: a simplex method in integers, at most 10 terms in the answer.
[[nodiscard]] Contradiction find_contradiction(const KeepTable& table, DescriptorRun run);

/// Checks a contradiction by adding up; shares nothing with the search.
[[nodiscard]] bool shows_inseparable(const Contradiction& contradiction, const KeepTable& table,
                                     DescriptorRun run);

/// A neuron with whole numbers: it says "keep" where bias + sum of weight[i] n_i is at least 0.
struct IntegerNeuron {
  std::array<std::int32_t, kNetInputs> weight{};
  std::int32_t bias = 0;
};

/// Whether the neuron is correct on each descriptor of the run.
[[nodiscard]] bool recognises(const IntegerNeuron& neuron, const KeepTable& table,
                              DescriptorRun run);

struct TrainedNeuron {
  IntegerNeuron neuron;
  int epochs = 0;  // scans of the run, the last, which changed nothing, included
};

/// From zero, adds a vector that should be kept and subtracts one that should not, until all are
/// correct. Ends for every separable run (convergence theorem); throws std::runtime_error after a
/// million epochs, which only a run that is not separable can take at these sizes.
[[nodiscard]] TrainedNeuron train_perceptron(const KeepTable& table, DescriptorRun run);

/// A neuron that is correct on the same run with a smaller sum of magnitudes, found by steps of one
/// in up to three weights, the bias following. Small, not necessarily the smallest.
[[nodiscard]] IntegerNeuron shrink(const IntegerNeuron& neuron, const KeepTable& table,
                                   DescriptorRun run);

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

/// A table of the runs: weights, epochs, and the contradiction that ends each run.
[[nodiscard]] std::string cluster_markdown(const std::vector<TrainedRun>& runs);

/// A header that defines kTrainedCluster, with `command`, which made it, in its comment.
[[nodiscard]] std::string cluster_header(const ClusterWeights& weights, const std::string& command);

}  // namespace thinbench
