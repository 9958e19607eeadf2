// Finds the keys of a row, with byte compress where the ISA has it. For ISA files only.
#pragma once

#include <type_traits>

#include "regions/run_rows.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

static_assert(std::is_same_v<Key, IntBatch::value_type>);

/// As find_keys_of_word; with byte compress it writes whole vectors of keys.
///   bits       ..1....1.1     bytes  0 2 7 0 ..      keys  2 (64 word + 1 + byte) + (is an end)
[[gnu::always_inline]] inline int store_keys(std::uint64_t bits, Index word, Index before,
                                             Key* keys) {
  if constexpr (!kHasByteCompress) {
    return static_cast<int>(find_keys_of_word(bits, word, before, keys));
  } else {
    const ByteBatch bytes = set_bit_places(bits);
    // Every other boundary ends a run: the first one if an odd number of keys precedes it.
    const WordBatch is_end(before % 2 == 0 ? std::uint64_t{1} << 32 : 1);
    const IntBatch first =
        IntBatch(static_cast<Key>(2 * (word * kWordBits + 1))) + reinterpreted<IntBatch>(is_end);
    const auto store = [&](IntBatch sixteen, Index at) {
      ((sixteen << 1) + first).store_unaligned(keys + at);
    };
    const int count = __builtin_popcountll(bits);
    store(widened_quarter<0>(bytes), 0);
    if (__builtin_expect(count > 16, 0)) {
      store(widened_quarter<1>(bytes), 16);
      store(widened_quarter<2>(bytes), 32);
      store(widened_quarter<3>(bytes), 48);
    }
    return count;
  }
}

/// Writes the keys of a row and returns their number. Where a register holds eight words, words
/// without boundaries are skipped eight at a time.
[[gnu::always_inline]] inline Index find_keys_of_row(const std::uint64_t* row, Index words,
                                                     Key* keys) {
  if constexpr (!kRegisterHoldsRow) {
    return find_keys(row, words, keys);
  } else {
    Index count = 0;
    for (Index block = 0; block < words; block += kBlockWords) {
      const WordBatch here = WordBatch::load_unaligned(row + block);
      const WordBatch differing = here ^ WordTraits<WordBatch>::west(here, row + block);
      for (std::uint32_t left = nonzero_lanes(differing); left != 0; left &= left - 1) {
        const Index word = block + __builtin_ctz(left);
        count += store_keys(boundaries(row + word), word, count, keys + count);
      }
    }
    end_keys(keys, count);
    return count;
  }
}

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
