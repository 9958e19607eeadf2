// The two-layer net with a linear threshold on 8-bit integers, one pixel per byte lane: 16, 32 or
// 64 per operation. Compiled for every ISA.
//
// Cost per batch: 64 masked additions (on AVX-512 a word of neighbours is the mask), 3 operations
// per hidden output, and per pair of hidden neurons 2 interleavings, 2 multiply-adds and 2
// additions in 16 bits: about 115 operations for 64 pixels on AVX-512.
#include "core/exported.hpp"
#include "simd/vector.hpp"
#include "techniques/changed_pixels.hpp"
#include "techniques/net_kernels.hpp"
#include "techniques/net_model.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

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

std::uint64_t fixed_point_bits(const TableRule* rule, const std::uint64_t* fixed,
                               const ConstBitPlaneView& previous, const ConstBitPlaneView& source,
                               const BitPlaneView& target, const Band& band) {
  return decide_changed(FixedPointDecider{net_of(rule).fixed_point}, fixed, previous, source,
                        target, band);
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const FixedPointKernels Exported<FixedPointKernels, kThisIsa>::kKernels = {
    &fixed_point_bits};

}  // namespace thinbench::detail
