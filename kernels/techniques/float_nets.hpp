// The three nets in single precision, one pixel per lane, for any weights. Sums are taken in the
// order that thinbench/nets.hpp defines, so lanes are bit-identical to the reference. For ISA files
// only.
#pragma once

#include "rules/exponential.hpp"
#include "techniques/changed_pixels.hpp"
#include "techniques/net_model.hpp"

namespace thinbench::detail {

template <>
struct RealOps<FloatBatch> {
  [[gnu::always_inline]] static FloatBatch constant(float value) { return FloatBatch(value); }
  [[gnu::always_inline]] static FloatBatch clamped(FloatBatch x, float low, float high) {
    return simd::min(simd::max(x, FloatBatch(low)), FloatBatch(high));
  }
  [[gnu::always_inline]] static FloatBatch rounded(FloatBatch x) {
    const FloatBatch magic(12582912.0F);
    return (x + magic) - magic;
  }
  [[gnu::always_inline]] static FloatBatch power_of_two(FloatBatch n) {
    const IntBatch bits = (simd::to_int(n) + IntBatch(127)) << 23;
    return reinterpreted<FloatBatch>(bits);
  }
};

inline namespace THINBENCH_ISA {

inline constexpr Index kFloatLanes = static_cast<Index>(FloatBatch::size);

/// Makes each addition load and broadcast its own weight. Without this barrier GCC hoists 81
/// weights out of the loop, spills them and reloads whole registers.
[[gnu::always_inline]] inline void keep_loads_in_loop() {
  asm volatile("" : : : "memory");
}

/// Neighbours as lane masks: a product with an input of 0 or 1 is a masked addition.
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
[[gnu::always_inline]] inline FloatBatch activated(FloatBatch x) {
  if constexpr (activation == Activation::sigmoid) {
    return sigmoid(x);
  } else {
    const FloatBatch inside = FloatBatch(0.166F) * x + FloatBatch(0.5F);
    const FloatBatch at_least_0 = simd::select(x < FloatBatch(-3.0F), FloatBatch(0.0F), inside);
    return simd::select(x > FloatBatch(3.0F), FloatBatch(1.0F), at_least_0);
  }
}

/// Equations (3) and (4) with activation (1) or (2). Operations per batch with the linear
/// threshold: 64 masked additions, 8 x 6 for hidden activations, 16 + 6 for the output.
template <Activation activation>
struct TwoLayerNet {
  template <class Inputs>
  [[gnu::always_inline]] static FloatBatch hidden(const NetModel& model, const Inputs& inputs,
                                                  int j) {
    const Neuron& neuron = model.two_layer.hidden[j];
    FloatBatch sum(neuron.bias);
#pragma GCC unroll 8
    for (int i = 0; i < kNetInputs; ++i) sum = inputs.add(i, sum, FloatBatch(neuron.weight[i]));
    return activated<activation>(sum);
  }

  template <class Inputs>
  [[gnu::always_inline]] static FloatBatch output(const NetModel& model, const Inputs& inputs) {
    keep_loads_in_loop();
    FloatBatch sum(model.two_layer.output.bias);
#pragma GCC unroll 8
    for (int j = 0; j < kHiddenNeurons; ++j) {
      sum = sum + FloatBatch(model.two_layer.output.weight[j]) * hidden(model, inputs, j);
    }
    return activated<activation>(sum);
  }

  template <class Inputs>
  [[gnu::always_inline]] static std::uint64_t decide(const NetModel& model, const Inputs& inputs) {
    return bits_of(output(model, inputs) >= FloatBatch(0.5F));
  }
};

/// Equations (5) to (7): the descriptor selects a net, whose weights are looked up. Operations per
/// batch: 8 additions, 2 per net, 2 per input.
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
      net = net + simd::select(descriptor > FloatBatch(model.cluster_last[run]), FloatBatch(1.0F),
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

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
