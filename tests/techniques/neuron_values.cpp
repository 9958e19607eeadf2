// Compiled per ISA.
#include "techniques/neuron_values.hpp"

#include "core/exported.hpp"
#include "techniques/float_nets.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

/// Neighbours of descriptors `first`, `first` + 1, ..., one in each lane.
PackedNeighbours neighbours_from(Index first) {
  PackedNeighbours neighbours{};
  for (Index lane = 0; lane < kFloatLanes; ++lane) {
    for (int i = 0; i < kNetInputs; ++i) {
      neighbours.n[i] |= static_cast<std::uint64_t>((first + lane) >> i & 1) << lane;
    }
  }
  return neighbours;
}

template <Activation activation>
void neuron_values(const NetModel& model, float* values) {
  using Net = TwoLayerNet<activation>;
  for (Index first = 0; first < 256; first += kFloatLanes) {
    const MaskInputs inputs = mask_inputs(neighbours_from(first), 0);
    for (int j = 0; j < kHiddenNeurons; ++j) {
      Net::hidden(model, inputs, j).store_unaligned(values + 256 * j + first);
    }
    Net::output(model, inputs).store_unaligned(values + 256 * kHiddenNeurons + first);
  }
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const NeuronValues Exported<NeuronValues, kThisIsa>::kKernels = {
    &neuron_values<Activation::sigmoid>, &neuron_values<Activation::linear>};

}  // namespace thinbench::detail
