#include "training/cluster_training.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace thinbench {
namespace {

void check(bool holds, const char* what, DescriptorRun run) {
  if (holds) return;
  throw std::logic_error(std::string(what) + " does not hold for descriptors " +
                         std::to_string(run.first) + " to " + std::to_string(run.last));
}

/// The end of the longest separable run from `first` on, by bisection: what can be learned can be
/// learned when it is shortened.
std::pair<int, Contradiction> longest_run(const KeepTable& table, int first) {
  int last = first;  // one vector is always separable
  int too_far = kDescriptors;
  Contradiction reason;
  while (too_far - last > 1) {
    const int middle = (last + too_far) / 2;
    Contradiction found = find_contradiction(table, {first, middle});
    if (found.empty()) {
      last = middle;
      continue;
    }
    check(proves_inseparable(found, table, {first, middle}), "the contradiction", {first, middle});
    too_far = middle;
    reason = std::move(found);
  }
  return {last, reason};
}

TrainedRun train_run(const KeepTable& table, int first, bool small_integers) {
  auto [last, reason] = longest_run(table, first);
  const DescriptorRun run = {first, last};
  TrainedNeuron trained = train_perceptron(table, run);
  if (small_integers) trained.neuron = shrink(trained.neuron, table, run);
  check(recognises(trained.neuron, table, run), "the neuron", run);
  return {run, trained.neuron, trained.epochs, std::move(reason)};
}

}  // namespace

std::vector<TrainedRun> train_cluster(const KeepTable& table, const ClusterTraining& training) {
  std::vector<TrainedRun> runs;
  for (int first = 0; first < kDescriptors; first = runs.back().run.last + 1) {
    runs.push_back(train_run(table, first, training.small_integers));
  }
  if (runs.size() > static_cast<std::size_t>(training.max_nets)) {
    throw std::runtime_error("the rule takes " + std::to_string(runs.size()) +
                             " nets, proved to be the fewest; allowed are " +
                             std::to_string(training.max_nets));
  }
  return runs;
}

ClusterWeights cluster_weights(const std::vector<TrainedRun>& runs) {
  if (runs.size() > static_cast<std::size_t>(kMaxClusterNets)) {
    throw std::runtime_error("a cluster holds at most " + std::to_string(kMaxClusterNets) +
                             " nets, not " + std::to_string(runs.size()));
  }
  ClusterWeights weights{};
  for (const TrainedRun& trained : runs) {
    weights.nets[weights.count++] = {trained.run.last, to_neuron(trained.neuron)};
  }
  return weights;
}

}  // namespace thinbench
