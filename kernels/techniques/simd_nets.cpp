// Nets on packed pixels: changed neighbourhoods only (changed_pixels.hpp), a word of neighbours is
// the mask of an addition. Compiled per ISA.
//
// simd_float_bits: in single precision, one pixel per lane (float_nets.hpp).
//
// simd_fixed_point: the two-layer net with a linear threshold on 8-bit integers, one pixel per byte
// lane: 16, 32 or 64 per operation. Cost per batch: 64 masked additions (on AVX-512 a word of
// neighbours is the mask), 3 operations per hidden output, and per pair of hidden neurons 2
// interleavings, 2 multiply-adds and 2 additions in 16 bits: about 115 operations for 64 pixels on
// AVX-512.
#include "core/exported.hpp"
#include "techniques/changed_pixels.hpp"
#include "techniques/float_nets.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

template <class Net>
struct FloatDecider {
  static constexpr Index kLanes = kFloatLanes;
  const NetModel& model;

  [[gnu::always_inline]] std::uint64_t operator()(const PackedNeighbours& neighbours,
                                                  Index first) const {
    return Net::decide(model, mask_inputs(neighbours, first));
  }
};

template <class Net>
std::uint64_t float_bits(const NetModel& model, const std::uint64_t* fixed,
                         const ConstBitPlaneView& previous, const ConstBitPlaneView& source,
                         const BitPlaneView& target, const Band& band) {
  return decide_changed(FloatDecider<Net>{model}, fixed, previous, source, target, band);
}

constexpr Index kByteLanes = static_cast<Index>(ByteBatch::size);

struct ByteInputs {
  ByteMask mask[kNetInputs];
};

/// The output of hidden neuron j, in [0, 2 limit].
[[gnu::always_inline]] inline ByteBatch hidden_output(const FixedPointNet& net, int j,
                                                      const ByteInputs& inputs) {
  SignedByteBatch sum(net.bias[j]);
#pragma GCC unroll 8
  for (int i = 0; i < kNetInputs; ++i) {
    sum = add_where(inputs.mask[i], sum, SignedByteBatch(net.weight[j][i]));
  }
  const SignedByteBatch limit(net.limit);
  const SignedByteBatch min_sum = SignedByteBatch(std::int8_t{0}) - limit;
  return reinterpreted<ByteBatch>(simd::min(simd::max(sum, min_sum), limit) + limit);
}

[[gnu::always_inline]] inline std::uint64_t decide(const FixedPointNet& net,
                                                   const ByteInputs& inputs) {
  const WideBatch bias(net.output_bias);
  Halves sums = {bias, bias};
#pragma GCC unroll 4
  for (int j = 0; j < kHiddenNeurons; j += 2) {
    const Halves hidden =
        interleaved(hidden_output(net, j, inputs), hidden_output(net, j + 1, inputs));
    const WideBatch weights(static_cast<std::int16_t>(
        static_cast<std::uint8_t>(net.output_weight[j]) | net.output_weight[j + 1] * 256));
    sums.low = sums.low + weighted_pairs(hidden.low, weights);
    sums.high = sums.high + weighted_pairs(hidden.high, weights);
  }
  return nonnegative_bits(sums);
}

struct FixedPointDecider {
  static constexpr Index kLanes = kByteLanes;
  FixedPointNet net;

  [[gnu::always_inline]] std::uint64_t operator()(const PackedNeighbours& neighbours,
                                                  Index first) const {
    ByteInputs inputs;
    for (int i = 0; i < kNetInputs; ++i) inputs.mask[i] = byte_mask(neighbours.n[i] >> first);
    return decide(net, inputs);
  }
};

std::uint64_t fixed_point_bits(const NetModel& model, const std::uint64_t* fixed,
                               const ConstBitPlaneView& previous, const ConstBitPlaneView& source,
                               const BitPlaneView& target, const Band& band) {
  return decide_changed(FixedPointDecider{model.fixed_point}, fixed, previous, source, target,
                        band);
}

using Sigmoid = TwoLayerNet<Activation::sigmoid>;
using Linear = TwoLayerNet<Activation::linear>;

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const NetPasses Exported<NetPasses, kThisIsa>::kKernels = {
    {&float_bits<Sigmoid>, &float_bits<Linear>, &float_bits<ClusterOfNets>}, &fixed_point_bits};

}  // namespace thinbench::detail
