// The two-layer net of section 3.2 with any number of hidden neurons, for training and experiments.
#pragma once

#include <vector>

#include "thinbench/nets.hpp"
#include "training/keep_table.hpp"

namespace thinbench {

struct HiddenLayerNet {
  std::vector<Neuron> hidden;
  std::vector<float> output_weight;  // as many as hidden neurons
  float output_bias = 0;
};

[[nodiscard]] HiddenLayerNet to_net(const TwoLayerWeights& weights);

/// Throws std::invalid_argument unless the net has eight hidden neurons.
[[nodiscard]] TwoLayerWeights to_weights(const HiddenLayerNet& net);

/// Equation (1) or (2), with an exponential that is the same on every machine.
[[nodiscard]] float activate(float x, Activation activation);

/// Equation (3) and the step function (4): whether a foreground pixel with these neighbours, 0 or
/// 1, is kept.
[[nodiscard]] bool net_keeps(const HiddenLayerNet& net, const float (&n)[kNetInputs],
                             Activation activation);

/// What the net says of each descriptor.
[[nodiscard]] KeepTable table_of(const HiddenLayerNet& net, Activation activation);

/// Entries that two tables share, of 256.
[[nodiscard]] int agreement(const KeepTable& a, const KeepTable& b);

}  // namespace thinbench
