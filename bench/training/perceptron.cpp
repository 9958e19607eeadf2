#include "training/perceptron.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>
#include <stdexcept>

namespace thinbench {
namespace {

constexpr int kMostEpochs = 1'000'000;

void add_vector(IntegerNeuron& neuron, int descriptor, int sign) {
  for (int i = 0; i < kNetInputs; ++i) {
    neuron.weight[static_cast<std::size_t>(i)] += sign * neighbour(descriptor, i);
  }
  neuron.bias += sign;
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

std::int32_t net_input(const IntegerNeuron& neuron, int descriptor) {
  std::int32_t sum = neuron.bias;
  for (int i = 0; i < kNetInputs; ++i) {
    sum += neuron.weight[static_cast<std::size_t>(i)] * neighbour(descriptor, i);
  }
  return sum;
}

bool recognises(const IntegerNeuron& neuron, const KeepTable& table, DescriptorRun run) {
  for (int k = run.first; k <= run.last; ++k) {
    if ((net_input(neuron, k) >= 0) != keeps(table, k)) return false;
  }
  return true;
}

TrainedNeuron train_perceptron(const KeepTable& table, DescriptorRun run) {
  TrainedNeuron trained;
  for (bool changed = true; changed; ++trained.epochs) {
    if (trained.epochs == kMostEpochs) {
      throw std::runtime_error("the perceptron rule found no weights for descriptors " +
                               std::to_string(run.first) + " to " + std::to_string(run.last));
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

Neuron to_neuron(const IntegerNeuron& neuron) {
  Neuron result{};
  for (std::size_t i = 0; i < neuron.weight.size(); ++i) {
    result.weight[i] = static_cast<float>(neuron.weight[i]);
  }
  result.bias = static_cast<float>(neuron.bias);
  return result;
}

}  // namespace thinbench
