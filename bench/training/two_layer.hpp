// The two-layer net of section 3.2 with any number of hidden neurons, and its training by
// back-propagation.
#pragma once

#include <cstdint>
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

struct TwoLayerTraining {
  std::uint64_t seed = 1;
  int hidden = kHiddenNeurons;
  int max_restarts = 20;    // fresh random weights after the first
  int max_epochs = 2000;    // of each start; an epoch shows all 256 vectors
  bool also_linear = true;  // go on until equation (2) in place of (1) is correct as well
};

/// The net, its weights rounded to hundredths as Table 1 prints them, and what it took.
struct TrainedTwoLayer {
  HiddenLayerNet net;
  int right_sigmoid = 0;  // descriptors of 256, with the rounded weights
  int right_linear = 0;
  int restarts = 0;
  int epochs = 0;        // of the last start
  int total_epochs = 0;  // of all starts
};

/// Trains a net on a keep table with the sigmoid, seeded: the same numbers on every machine. Stops
/// when the rounded weights are correct on all 256 descriptors, or after the allowed starts; then
/// the best net seen is returned.
[[nodiscard]] TrainedTwoLayer train_two_layer(const KeepTable& table,
                                              const TwoLayerTraining& training);

}  // namespace thinbench
