// The output of every neuron of a two-layer net, computed by the vector code of the kernels.
#pragma once

#include "core/exported.hpp"
#include "techniques/net_model.hpp"

namespace thinbench::detail {

/// Each function writes 9 x 256 values: for hidden neurons 0 to 7 and then for the output neuron,
/// one per descriptor. Compiled per ISA.
struct NeuronValues {
  void (*sigmoid)(const NetModel& model, float* values);
  void (*linear)(const NetModel& model, float* values);
};
template <>
inline constexpr Features kGainsFrom<NeuronValues> = ~Features{0};

}  // namespace thinbench::detail
