// The keys of a row as fast as a level finds them. For ISA files only.
#pragma once

#include "simd/batch.hpp"
#include "regions/run_rows.hpp"

namespace thinbench::detail {

#ifdef __AVX512VBMI2__
/// Writes the keys of a word's boundaries, whole vectors of them, and returns how many there are.
///   bits       ..1....1.1     bytes  0 2 7 0 ..      keys  2 (64 word + 1 + byte) + (is an end)
[[gnu::always_inline]] inline int store_keys(std::uint64_t bits, Index word, Index before,
                                             Key* keys) {
  const __m512i numbers = _mm512_set_epi8(
      63, 62, 61, 60, 59, 58, 57, 56, 55, 54, 53, 52, 51, 50, 49, 48, 47, 46, 45, 44, 43, 42, 41,
      40, 39, 38, 37, 36, 35, 34, 33, 32, 31, 30, 29, 28, 27, 26, 25, 24, 23, 22, 21, 20, 19, 18,
      17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
  const __m512i bytes = _mm512_maskz_compress_epi8(bits, numbers);
  // Every other boundary is an end, the first one where an odd number came before.
  const __m512i is_end = _mm512_set1_epi64(before % 2 == 0 ? std::int64_t{1} << 32 : 1);
  const __m512i first =
      _mm512_add_epi32(_mm512_set1_epi32(static_cast<Key>(2 * (word * kWordBits + 1))), is_end);
  const auto store = [&](__m128i sixteen, Index at) {
    const __m512i wide = _mm512_cvtepu8_epi32(sixteen);
    _mm512_storeu_si512(keys + at, _mm512_add_epi32(_mm512_slli_epi32(wide, 1), first));
  };
  const int count = __builtin_popcountll(bits);
  store(_mm512_castsi512_si128(bytes), 0);
  if (__builtin_expect(count > 16, 0)) {
    store(_mm512_extracti32x4_epi32(bytes, 1), 16);
    store(_mm512_extracti32x4_epi32(bytes, 2), 32);
    store(_mm512_extracti32x4_epi32(bytes, 3), 48);
  }
  return count;
}
#elif defined(__AVX512F__)
[[gnu::always_inline]] inline int store_keys(std::uint64_t bits, Index word, Index before,
                                             Key* keys) {
  return static_cast<int>(find_keys_of_word(bits, word, before, keys));
}
#endif

#ifdef __AVX512F__
/// One bit for each of the eight words that has boundaries.
[[gnu::always_inline]] inline unsigned words_that_count(const std::uint64_t* words) {
  const WordBatch here = WordBatch::load_unaligned(words);
  const WordBatch differing = here ^ WordTraits<WordBatch>::west(here, words);
  return _mm512_test_epi64_mask(differing, differing);
}

/// Writes the keys of a row and returns how many there are; words without boundaries are passed
/// over, eight at a time.
[[gnu::always_inline]] inline Index find_keys_of_row(const std::uint64_t* row, Index words,
                                                     Key* keys) {
  Index count = 0;
  for (Index block = 0; block < words; block += kBlockWords) {
    for (unsigned left = words_that_count(row + block); left != 0; left &= left - 1) {
      const Index word = block + __builtin_ctz(left);
      count += store_keys(boundaries(row + word), word, count, keys + count);
    }
  }
  end_keys(keys, count);
  return count;
}
#else
[[gnu::always_inline]] inline Index find_keys_of_row(const std::uint64_t* row, Index words,
                                                     Key* keys) {
  return find_keys(row, words, keys);
}
#endif

}  // namespace thinbench::detail
