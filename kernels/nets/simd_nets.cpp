// Nets on xsimd batches, pixels across lanes, compiled once for every instruction-set level.
//
// float_bits reads packed bits and asks about changed neighbourhoods only (changed_pixels.hpp); a
// word of neighbours is the mask of an addition. float_bytes reads bytes 0/1, asks about every dark
// pixel in every step, passes over batches without one, and multiplies.
#include "nets/changed_pixels.hpp"
#include "nets/float_nets.hpp"
#include "nets/model_passes.hpp"

namespace thinbench::detail {
namespace {

[[gnu::always_inline]] inline MaskInputs mask_inputs(const PackedNeighbours& from, Index first) {
  MaskInputs inputs;
  for (int i = 0; i < kNetInputs; ++i) inputs.mask[i] = lane_mask(from.n[i] >> first);
  return inputs;
}

template <class Net>
struct FloatDecider {
  static constexpr Index kLanes = kFloatLanes;
  const RuleModel& model;

  [[gnu::always_inline]] std::uint64_t operator()(const PackedNeighbours& neighbours,
                                                  Index first) const {
    return Net::decide(model, mask_inputs(neighbours, first));
  }
};

template <class Net>
std::uint64_t float_bits(const RuleModel* model, const ConstBitPlaneView& previous,
                         const ConstBitPlaneView& source, const BitPlaneView& target,
                         const Band& band) {
  return decide_changed(FloatDecider<Net>{*model}, previous, source, target, band);
}

[[gnu::always_inline]] inline NumberInputs number_inputs(const std::uint8_t* here, Index stride) {
  const std::uint8_t* above = here - stride;
  const std::uint8_t* below = here + stride;
  return {{load_bytes(here + 1), load_bytes(above + 1), load_bytes(above), load_bytes(above - 1),
           load_bytes(here - 1), load_bytes(below - 1), load_bytes(below), load_bytes(below + 1)}};
}

template <class Net>
bool float_bytes_row(const RuleModel& model, const std::uint8_t* here, Index stride,
                     std::uint8_t* target, Index count) {
  bool changed = false;
  for (Index x = 0; x < count; x += kFloatLanes) {
    const std::uint64_t dark = bits_of(load_bytes(here + x) != FloatBatch(0.0F));
    const std::uint64_t stays =
        dark == 0 ? 0 : dark & Net::decide(model, number_inputs(here + x, stride));
    changed = changed || stays != dark;
    for (Index i = 0; i < kFloatLanes; ++i) target[x + i] = stays >> i & 1;
  }
  return changed;
}

template <class Net>
std::uint64_t float_bytes(const RuleModel* model, const ConstBytePlaneView& source,
                          const BytePlaneView& target, const Band& band) {
  return for_each_run(band, [&](Index y, Index from, Index to) {
    return float_bytes_row<Net>(*model, source.row(y) + from, source.stride, target.row(y) + from,
                                to - from);
  });
}

using Sigmoid = TwoLayerNet<Activation::sigmoid>;
using Linear = TwoLayerNet<Activation::linear>;

/// Descriptors 0 to 255, a batch at a time.
template <Activation activation>
void neuron_values(const RuleModel& model, float* values) {
  for (Index first = 0; first < 256; first += kFloatLanes) {
    PackedNeighbours neighbours{};
    for (Index lane = 0; lane < kFloatLanes; ++lane) {
      for (int i = 0; i < kNetInputs; ++i) {
        neighbours.n[i] |= static_cast<std::uint64_t>((first + lane) >> i & 1) << lane;
      }
    }
    const MaskInputs inputs = mask_inputs(neighbours, 0);
    for (int j = 0; j < kHiddenNeurons; ++j) {
      TwoLayerNet<activation>::hidden(model, inputs, j).store_unaligned(values + 256 * j + first);
    }
    float* output = values + 256 * kHiddenNeurons + first;
    TwoLayerNet<activation>::output(model, inputs).store_unaligned(output);
  }
}

}  // namespace

template <>
constinit const NeuronValues IsaModelPasses<kThisIsa>::kNeuronValues = {
    &neuron_values<Activation::sigmoid>, &neuron_values<Activation::linear>};

template <>
constinit const NetPasses<ChangePass> IsaModelPasses<kThisIsa>::kFloatBits = {
    &float_bits<Sigmoid>, &float_bits<Linear>, &float_bits<ClusterOfNets>};

template <>
constinit const NetPasses<Pass<std::uint8_t>> IsaModelPasses<kThisIsa>::kFloatBytes = {
    &float_bytes<Sigmoid>, &float_bytes<Linear>, &float_bytes<ClusterOfNets>};

}  // namespace thinbench::detail
