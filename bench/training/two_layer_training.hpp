// Back-propagation for the two-layer net of section 3.2.
#pragma once

#include <cstdint>

#include "training/two_layer_net.hpp"

namespace thinbench {

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
