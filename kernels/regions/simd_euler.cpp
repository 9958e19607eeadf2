// The Euler number on vectors of packed words, compiled for every level.
//
// Cost a vector of 128, 256 or 512 pixels: 4 loads, 6 operations for the western neighbours (2 with
// funnel shifts), 6 gates (4 with vpternlog) and two counts: 2 instructions with VPOPCNTDQ; else a
// table of 16 nibbles by byte shuffles, 9 instructions for the difference of both. Below AVX2,
// where the shuffle would count 16 bytes, one popcnt a word is as fast: the loop runs on 64-bit
// words.
#include "dispatch/exported.hpp"
#include "simd/batch.hpp"
#include "regions/euler.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

#if defined(__AVX512VPOPCNTDQ__)
struct BatchCounter {
  __m512i total = _mm512_setzero_si512();
  [[gnu::always_inline]] void add(const EulerTerms<WordBatch>& terms) {
    total = _mm512_add_epi64(total, _mm512_popcnt_epi64(terms.plus));
    total = _mm512_sub_epi64(total, _mm512_popcnt_epi64(terms.minus));
  }
  [[nodiscard]] [[gnu::always_inline]] std::int64_t sum() const {
    return _mm512_reduce_add_epi64(total);
  }
};
using CountedWord = WordBatch;
using Counter = BatchCounter;
#elif defined(__AVX512BW__)
/// Nibble counts of `plus`, and 4 minus those of `minus`, so that bytes stay positive: 16 a byte
/// too much at most, 64 a lane.
struct BatchCounter {
  __m512i total = _mm512_setzero_si512();
  std::int64_t lanes = 0;
  [[gnu::always_inline]] void add(const EulerTerms<WordBatch>& terms) {
    const __m512i counts =
        _mm512_broadcast_i32x4(_mm_setr_epi8(0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4));
    const __m512i rest = _mm512_sub_epi8(_mm512_set1_epi8(4), counts);
    const __m512i low = _mm512_set1_epi8(15);
    const auto look_up = [&](__m512i table, __m512i bits) {
      const __m512i high = _mm512_and_si512(_mm512_srli_epi16(bits, 4), low);
      return _mm512_add_epi8(_mm512_shuffle_epi8(table, _mm512_and_si512(bits, low)),
                             _mm512_shuffle_epi8(table, high));
    };
    const __m512i bytes = _mm512_add_epi8(look_up(counts, terms.plus), look_up(rest, terms.minus));
    total = _mm512_add_epi64(total, _mm512_sad_epu8(bytes, _mm512_setzero_si512()));
    lanes += static_cast<std::int64_t>(WordBatch::size);
  }
  [[nodiscard]] [[gnu::always_inline]] std::int64_t sum() const {
    return _mm512_reduce_add_epi64(total) - lanes * kWordBits;
  }
};
using CountedWord = WordBatch;
using Counter = BatchCounter;
#elif defined(__AVX2__)
/// Nibble counts of `plus`, and 4 minus those of `minus`, so that bytes stay positive: 64 a lane
/// too much.
struct BatchCounter {
  __m256i total = _mm256_setzero_si256();
  std::int64_t lanes = 0;
  [[gnu::always_inline]] void add(const EulerTerms<WordBatch>& terms) {
    const __m256i counts =
        _mm256_broadcastsi128_si256(_mm_setr_epi8(0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4));
    const __m256i rest = _mm256_sub_epi8(_mm256_set1_epi8(4), counts);
    const __m256i low = _mm256_set1_epi8(15);
    const auto look_up = [&](__m256i table, __m256i bits) {
      const __m256i high = _mm256_and_si256(_mm256_srli_epi16(bits, 4), low);
      return _mm256_add_epi8(_mm256_shuffle_epi8(table, _mm256_and_si256(bits, low)),
                             _mm256_shuffle_epi8(table, high));
    };
    const __m256i bytes = _mm256_add_epi8(look_up(counts, terms.plus), look_up(rest, terms.minus));
    total = _mm256_add_epi64(total, _mm256_sad_epu8(bytes, _mm256_setzero_si256()));
    lanes += static_cast<std::int64_t>(WordBatch::size);
  }
  [[nodiscard]] [[gnu::always_inline]] std::int64_t sum() const {
    const __m128i half =
        _mm_add_epi64(_mm256_castsi256_si128(total), _mm256_extracti128_si256(total, 1));
    return _mm_cvtsi128_si64(half) + _mm_extract_epi64(half, 1) - lanes * kWordBits;
  }
};
using CountedWord = WordBatch;
using Counter = BatchCounter;
#else
using CountedWord = std::uint64_t;
using Counter = WordCounter;
#endif

template <class Connectivity>
std::int64_t count(const ConstBitPlaneView& image, Index first, Index last) {
  return sum_euler<Connectivity, CountedWord, Counter>(image, first, last);
}

}  // namespace

}  // namespace THINBENCH_ISA

template <>
constinit const EulerKernels Exported<EulerKernels, kThisIsa>::kKernels = {&count<EulerEight>, &count<EulerFour>};

}  // namespace thinbench::detail
