// What every neuron of a two-layer net answers, computed across lanes as the kernels do.
#pragma once

#include "nets/model.hpp"

namespace thinbench::detail {

/// Each writes 9 x 256 values: those of hidden neurons 0 to 7 and of the output, each for the
/// descriptors 0 to 255. Compiled for every ISA.
struct NeuronValues {
  void (*sigmoid)(const NetModel& model, float* values);
  void (*linear)(const NetModel& model, float* values);
};

}  // namespace thinbench::detail
