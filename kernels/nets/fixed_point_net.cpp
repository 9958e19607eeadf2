// The two-layer net with a linear threshold on 8-bit integers, pixels across byte lanes: 16, 32 or
// 64 an operation. Compiled once for every instruction-set level.
//
// Cost a batch: 64 masked additions (on AVX-512 a word of neighbours is the mask), 3 operations for
// each answer, and for each pair of hidden neurons 2 interleavings, 2 multiply-adds and 2 additions
// in 16 bits: about 115 operations for 64 pixels on AVX-512.
#include "dispatch/exported.hpp"
#include "nets/changed_pixels.hpp"
#include "nets/net_kernels.hpp"
#include "simd/batch.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

using SignedBatch = xsimd::batch<std::int8_t, Architecture>;
constexpr Index kByteLanes = static_cast<Index>(SignedBatch::size);

#if defined(__AVX512BW__)
using Register = __m512i;
using ByteMask = __mmask64;
[[gnu::always_inline]] inline ByteMask byte_mask(std::uint64_t bits) {
  return bits;
}
[[gnu::always_inline]] inline Register add_where(ByteMask mask, Register sum, std::int8_t value) {
  return _mm512_mask_add_epi8(sum, mask, sum, _mm512_set1_epi8(value));
}
[[gnu::always_inline]] inline Register interleave_low(Register a, Register b) {
  return _mm512_unpacklo_epi8(a, b);
}
[[gnu::always_inline]] inline Register interleave_high(Register a, Register b) {
  return _mm512_unpackhi_epi8(a, b);
}
[[gnu::always_inline]] inline Register add_products(Register sum, Register answers, Register pair) {
  return _mm512_add_epi16(sum, _mm512_maddubs_epi16(answers, pair));
}
[[gnu::always_inline]] inline Register words_of(std::int16_t value) {
  return _mm512_set1_epi16(value);
}
/// Bit i is set where sum i is not negative; saturation keeps signs, and packing undoes
/// interleaving.
[[gnu::always_inline]] inline std::uint64_t not_negative(Register low, Register high) {
  return ~_mm512_movepi8_mask(_mm512_packs_epi16(low, high));
}
#elif defined(__AVX2__)
using Register = __m256i;
using ByteMask = __m256i;
[[gnu::always_inline]] inline ByteMask byte_mask(std::uint64_t bits) {
  return spread_bits(bits);
}
[[gnu::always_inline]] inline Register add_where(ByteMask mask, Register sum, std::int8_t value) {
  return _mm256_add_epi8(sum, _mm256_and_si256(mask, _mm256_set1_epi8(value)));
}
[[gnu::always_inline]] inline Register interleave_low(Register a, Register b) {
  return _mm256_unpacklo_epi8(a, b);
}
[[gnu::always_inline]] inline Register interleave_high(Register a, Register b) {
  return _mm256_unpackhi_epi8(a, b);
}
[[gnu::always_inline]] inline Register add_products(Register sum, Register answers, Register pair) {
  return _mm256_add_epi16(sum, _mm256_maddubs_epi16(answers, pair));
}
[[gnu::always_inline]] inline Register words_of(std::int16_t value) {
  return _mm256_set1_epi16(value);
}
[[gnu::always_inline]] inline std::uint64_t not_negative(Register low, Register high) {
  return ~static_cast<std::uint32_t>(_mm256_movemask_epi8(_mm256_packs_epi16(low, high)));
}
#else
using Register = __m128i;
using ByteMask = __m128i;
[[gnu::always_inline]] inline ByteMask byte_mask(std::uint64_t bits) {
  return spread_bits(bits);
}
[[gnu::always_inline]] inline Register add_where(ByteMask mask, Register sum, std::int8_t value) {
  return _mm_add_epi8(sum, _mm_and_si128(mask, _mm_set1_epi8(value)));
}
[[gnu::always_inline]] inline Register interleave_low(Register a, Register b) {
  return _mm_unpacklo_epi8(a, b);
}
[[gnu::always_inline]] inline Register interleave_high(Register a, Register b) {
  return _mm_unpackhi_epi8(a, b);
}
[[gnu::always_inline]] inline Register add_products(Register sum, Register answers, Register pair) {
#if defined(__SSSE3__)
  return _mm_add_epi16(sum, _mm_maddubs_epi16(answers, pair));
#else
  // Without the mixed product: even and odd bytes apart, weights widened by shifts that keep the
  // sign.
  const __m128i even = _mm_mullo_epi16(_mm_and_si128(answers, _mm_set1_epi16(255)),
                                       _mm_srai_epi16(_mm_slli_epi16(pair, 8), 8));
  const __m128i odd = _mm_mullo_epi16(_mm_srli_epi16(answers, 8), _mm_srai_epi16(pair, 8));
  return _mm_add_epi16(sum, _mm_add_epi16(even, odd));
#endif
}
[[gnu::always_inline]] inline Register words_of(std::int16_t value) {
  return _mm_set1_epi16(value);
}
[[gnu::always_inline]] inline std::uint64_t not_negative(Register low, Register high) {
  return static_cast<std::uint16_t>(~_mm_movemask_epi8(_mm_packs_epi16(low, high)));
}
#endif

struct ByteInputs {
  ByteMask mask[kNetInputs];
};

/// The answer of hidden neuron j, in [0, 2 limit].
[[gnu::always_inline]] inline Register answer(const FixedPointNet& net, int j,
                                              const ByteInputs& inputs) {
  Register sum = SignedBatch(net.bias[j]);
#pragma GCC unroll 8
  for (int i = 0; i < kNetInputs; ++i) sum = add_where(inputs.mask[i], sum, net.weight[j][i]);
  const SignedBatch limit(net.limit);
  return xsimd::min(xsimd::max(SignedBatch(sum), SignedBatch(std::int8_t{0}) - limit), limit) +
         limit;
}

[[gnu::always_inline]] inline std::uint64_t decide(const FixedPointNet& net,
                                                   const ByteInputs& inputs) {
  Register low = words_of(net.output_bias);
  Register high = low;
#pragma GCC unroll 4
  for (int j = 0; j < kHiddenNeurons; j += 2) {
    const Register first = answer(net, j, inputs);
    const Register second = answer(net, j + 1, inputs);
    const auto pair = static_cast<std::int16_t>(static_cast<std::uint8_t>(net.output_weight[j]) |
                                                net.output_weight[j + 1] * 256);
    low = add_products(low, interleave_low(first, second), words_of(pair));
    high = add_products(high, interleave_high(first, second), words_of(pair));
  }
  return not_negative(low, high);
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

std::uint64_t fixed_point_bits(const RuntimeRule* rule, const std::uint64_t* fixed,
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
