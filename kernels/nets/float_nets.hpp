// The three nets in single precision with pixels across lanes. Nothing is known of what the weights
// decide; every sum is taken in the order that weights.hpp fixes, so lanes hold the reference's
// bits.
#pragma once

#include "nets/changed_pixels.hpp"
#include "nets/float_lanes.hpp"
#include "nets/model.hpp"

namespace thinbench::detail {

/// Weights are loaded and broadcast by the very addition that uses them. Left alone, GCC takes 81
/// of them out of the loop, spills them, and loads whole registers back.
[[gnu::always_inline]] inline void keep_loads_here() {
  asm volatile("" : : : "memory");
}

/// Neighbours as lane masks, from packed bits: a multiplication by 0 or 1 is a masked addition.
struct MaskInputs {
  LaneMask mask[kNetInputs];

  [[gnu::always_inline]] FloatBatch add(int i, FloatBatch sum, FloatBatch weight) const {
    return add_where(mask[i], sum, weight);
  }
};

[[gnu::always_inline]] inline MaskInputs mask_inputs(const PackedNeighbours& from, Index first) {
  MaskInputs inputs;
  for (int i = 0; i < kNetInputs; ++i) inputs.mask[i] = lane_mask(from.n[i] >> first);
  return inputs;
}

template <Activation activation>
[[gnu::always_inline]] inline FloatBatch answer(FloatBatch x) {
  if constexpr (activation == Activation::sigmoid) {
    return sigmoid(x);
  } else {
    const FloatBatch inside = FloatBatch(0.166F) * x + FloatBatch(0.5F);
    const FloatBatch not_below = xsimd::select(x < FloatBatch(-3.0F), FloatBatch(0.0F), inside);
    return xsimd::select(x > FloatBatch(3.0F), FloatBatch(1.0F), not_below);
  }
}

/// Equations (3) and (4) with activation (1) or (2). Cost a batch with the linear threshold: 64
/// masked additions, 8 x 6 for the answers, 16 for the output, 6 for its threshold.
template <Activation activation>
struct TwoLayerNet {
  template <class Inputs>
  [[gnu::always_inline]] static FloatBatch hidden(const NetModel& model, const Inputs& inputs,
                                                  int j) {
    const Neuron& neuron = model.two_layer.hidden[j];
    FloatBatch sum(neuron.bias);
#pragma GCC unroll 8
    for (int i = 0; i < kNetInputs; ++i) sum = inputs.add(i, sum, FloatBatch(neuron.weight[i]));
    return answer<activation>(sum);
  }

  template <class Inputs>
  [[gnu::always_inline]] static FloatBatch output(const NetModel& model, const Inputs& inputs) {
    keep_loads_here();
    FloatBatch sum(model.two_layer.output.bias);
#pragma GCC unroll 8
    for (int j = 0; j < kHiddenNeurons; ++j) {
      sum = sum + FloatBatch(model.two_layer.output.weight[j]) * hidden(model, inputs, j);
    }
    return answer<activation>(sum);
  }

  template <class Inputs>
  [[gnu::always_inline]] static std::uint64_t decide(const NetModel& model, const Inputs& inputs) {
    return bits_of(output(model, inputs) >= FloatBatch(0.5F));
  }
};

/// Equations (5) to (7): the descriptor, the net that is responsible for it, that net's weights by
/// look-up, and the step function. Cost a batch: 8 additions, 2 for each run, 2 for each input.
struct ClusterOfNets {
  template <class Inputs>
  [[gnu::always_inline]] static std::uint64_t decide(const NetModel& model, const Inputs& inputs) {
    FloatBatch descriptor(0.0F);
#pragma GCC unroll 8
    for (int i = 0; i < kNetInputs; ++i) {
      descriptor = inputs.add(i, descriptor, FloatBatch(static_cast<float>(1 << i)));
    }
    FloatBatch net(0.0F);
    const int runs = model.cluster.count;
    for (int run = 0; run + 1 < runs; ++run) {
      net = net + xsimd::select(descriptor > FloatBatch(model.cluster_last[run]), FloatBatch(1.0F),
                                FloatBatch(0.0F));
    }
    FloatBatch sum = look_up_16(model.cluster_column[kNetInputs], net);
#pragma GCC unroll 8
    for (int i = 0; i < kNetInputs; ++i) {
      sum = inputs.add(i, sum, look_up_16(model.cluster_column[i], net));
    }
    return bits_of(sum >= FloatBatch(0.0F));
  }
};

}  // namespace thinbench::detail
