// One neuron with the step function of equation (7), trained by the perceptron rule in integers.
#pragma once

#include <array>
#include <cstdint>

#include "training/separation.hpp"

namespace thinbench {

/// A neuron with whole numbers: it says "keep" where bias + sum of weight[i] n_i is at least 0.
struct IntegerNeuron {
  std::array<std::int32_t, kNetInputs> weight{};
  std::int32_t bias = 0;
};

[[nodiscard]] std::int32_t net_input(const IntegerNeuron& neuron, int descriptor);

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
/// in up to three weights, the bias following. Small, not proved smallest.
[[nodiscard]] IntegerNeuron shrink(const IntegerNeuron& neuron, const KeepTable& table,
                                   DescriptorRun run);

/// The same numbers in single precision, where they are exact.
[[nodiscard]] Neuron to_neuron(const IntegerNeuron& neuron);

}  // namespace thinbench
