#include "training/cluster.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "support/text.hpp"
#include "training/keep_table.hpp"

namespace thinbench {
namespace {

constexpr int kMaxEpochs = 1'000'000;

std::int32_t net_input(const IntegerNeuron& neuron, int descriptor) {
  std::int32_t sum = neuron.bias;
  for (int i = 0; i < kNetInputs; ++i) {
    sum += neuron.weight[static_cast<std::size_t>(i)] * neighbour(descriptor, i);
  }
  return sum;
}

void add_vector(IntegerNeuron& neuron, int descriptor, int sign) {
  for (int i = 0; i < kNetInputs; ++i) {
    neuron.weight[static_cast<std::size_t>(i)] += sign * neighbour(descriptor, i);
  }
  neuron.bias += sign;
}

/// The same numbers in single precision, where they are exact.
Neuron to_neuron(const IntegerNeuron& neuron) {
  Neuron result{};
  for (std::size_t i = 0; i < neuron.weight.size(); ++i) {
    result.weight[i] = static_cast<float>(neuron.weight[i]);
  }
  result.bias = static_cast<float>(neuron.bias);
  return result;
}

/// Sets the bias of smallest magnitude with which the weights are correct; nothing if there is
/// none.
std::optional<IntegerNeuron> with_smallest_bias(IntegerNeuron neuron, const KeepTable& table,
                                                DescriptorRun run) {
  neuron.bias = 0;
  std::int32_t lowest = std::numeric_limits<std::int32_t>::min();
  std::int32_t highest = std::numeric_limits<std::int32_t>::max();
  for (int k = run.first; k <= run.last; ++k) {
    const std::int32_t sum = net_input(neuron, k);
    if (keeps(table, k)) {
      lowest = std::max(lowest, -sum);
    } else {
      highest = std::min(highest, -sum - 1);
    }
  }
  if (lowest > highest) return std::nullopt;
  neuron.bias = std::clamp(0, lowest, highest);
  return neuron;
}

std::int64_t magnitude(const IntegerNeuron& neuron) {
  std::int64_t sum = std::abs(neuron.bias);
  for (const std::int32_t weight : neuron.weight) sum += std::abs(weight);
  return sum;
}

/// One smaller neuron among those that differ by a step of one in up to `steps` weights.
std::optional<IntegerNeuron> smaller(const IntegerNeuron& neuron, std::int64_t than,
                                     const KeepTable& table, DescriptorRun run, std::size_t from,
                                     int steps) {
  const std::optional<IntegerNeuron> fitted = with_smallest_bias(neuron, table, run);
  if (fitted && magnitude(*fitted) < than) return fitted;
  if (steps == 0) return std::nullopt;
  for (std::size_t i = from; i < neuron.weight.size(); ++i) {
    for (const int step : {-1, 1}) {
      IntegerNeuron changed = neuron;
      changed.weight[i] += step;
      if (auto found = smaller(changed, than, table, run, i + 1, steps - 1)) return found;
    }
  }
  return std::nullopt;
}

}  // namespace

bool recognises(const IntegerNeuron& neuron, const KeepTable& table, DescriptorRun run) {
  for (int k = run.first; k <= run.last; ++k) {
    if ((net_input(neuron, k) >= 0) != keeps(table, k)) return false;
  }
  return true;
}

TrainedNeuron train_perceptron(const KeepTable& table, DescriptorRun run) {
  TrainedNeuron trained;
  for (bool changed = true; changed; ++trained.epochs) {
    if (trained.epochs == kMaxEpochs) {
      throw std::runtime_error(fmt::format(
          "the perceptron rule found no weights for descriptors {} to {}", run.first, run.last));
    }
    changed = false;
    for (int k = run.first; k <= run.last; ++k) {
      if ((net_input(trained.neuron, k) >= 0) == keeps(table, k)) continue;
      add_vector(trained.neuron, k, keeps(table, k) ? 1 : -1);
      changed = true;
    }
  }
  return trained;
}

IntegerNeuron shrink(const IntegerNeuron& neuron, const KeepTable& table, DescriptorRun run) {
  constexpr int kSteps = 3;
  IntegerNeuron best = neuron;
  while (const auto found = smaller(best, magnitude(best), table, run, 0, kSteps)) best = *found;
  return best;
}

namespace {

void check(bool holds, const char* what, DescriptorRun run) {
  if (holds) return;
  throw std::logic_error(
      fmt::format("{} does not hold for descriptors {} to {}", what, run.first, run.last));
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
    check(shows_inseparable(found, table, {first, middle}), "the contradiction", {first, middle});
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
    throw std::runtime_error(fmt::format("the rule needs {} nets; --max-nets allows {}",
                                         runs.size(), training.max_nets));
  }
  return runs;
}

ClusterWeights cluster_weights(const std::vector<TrainedRun>& runs) {
  if (runs.size() > static_cast<std::size_t>(kMaxClusterNets)) {
    throw std::runtime_error(
        fmt::format("a cluster holds at most {} nets, not {}", kMaxClusterNets, runs.size()));
  }
  ClusterWeights weights{};
  for (const TrainedRun& trained : runs) {
    weights.nets[weights.count++] = {trained.run.last, to_neuron(trained.neuron)};
  }
  return weights;
}

namespace {

std::string times_and_descriptor(const WeightedDescriptor& term) {
  return term.times == 1 ? fmt::to_string(term.descriptor)
                         : fmt::format("{}×{}", term.times, term.descriptor);
}

/// "5 + 52 + 65 = 17 + 37 + 68": as vectors, the removed ones add up to the kept ones.
std::string equation(const Contradiction& contradiction, const KeepTable& table) {
  std::vector<std::string> removed;
  std::vector<std::string> kept;
  for (const WeightedDescriptor& term : contradiction) {
    (keeps(table, term.descriptor) ? kept : removed).push_back(times_and_descriptor(term));
  }
  return fmt::format("{} = {}", fmt::join(removed, " + "), fmt::join(kept, " + "));
}

/// A float literal of C++: 7.18F, -1.0F, 1e+20F.
std::string literal(float value) {
  const std::string text = fmt::to_string(value);
  const bool whole = text.find_first_of(".e") == std::string::npos;
  return text + (whole ? ".0F" : "F");
}

std::string net_initialiser(const ClusterNet& net) {
  std::vector<std::string> weights;
  for (const float weight : net.neuron.weight) weights.push_back(literal(weight));
  return fmt::format("{{{}, {{{{{}}}, {}}}}}", net.last, fmt::join(weights, ", "),
                     literal(net.neuron.bias));
}

}  // namespace

std::string cluster_markdown(const std::vector<TrainedRun>& runs) {
  const KeepTable table = keep_table_of_rule();
  std::vector<std::vector<std::string>> rows;
  for (const TrainedRun& trained : runs) {
    std::vector<std::string> row = {fmt::format("{}-{}", trained.run.first, trained.run.last)};
    for (const std::int32_t weight : trained.neuron.weight) row.push_back(std::to_string(weight));
    row.push_back(std::to_string(trained.neuron.bias));
    row.push_back(std::to_string(trained.epochs));
    row.push_back(trained.one_more.empty() ? "" : equation(trained.one_more, table));
    rows.push_back(row);
  }
  return markdown_table({"Descriptors", "W0", "W1", "W2", "W3", "W4", "W5", "W6", "W7", "B",
                         "Epochs", "One more is impossible: removed = kept"},
                        rows);
}

std::string cluster_header(const ClusterWeights& weights, const std::string& command) {
  std::vector<std::string> nets;
  nets.reserve(kMaxClusterNets);
  for (int n = 0; n < weights.count; ++n) nets.push_back(net_initialiser(weights.nets[n]));
  return fmt::format(
      R"(// Weights of a cluster of single-layer nets (section 3.3) that is right on all 256 descriptors of
// the modified Naccache-Shinghal rule, with as few nets as possible. Made by
//     {}
#pragma once

#include "thinbench/nets.hpp"

namespace thinbench::detail {{

inline constexpr ClusterWeights kTrainedCluster = {{
    {},
    {{{}}}}};

}}  // namespace thinbench::detail
)",
      command, weights.count, fmt::join(nets, ",\n     "));
}

}  // namespace thinbench
