// How registers hold rows, and where the west and east neighbours of their pixels are.
#pragma once

#include "simd/vector.hpp"
#include "thinning/engines/word_scan.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

/// A register that holds a whole row: pixels beyond both ends are background. A template, although
/// Word is always WordBatch: not every ISA has registers of 512 bits.
template <class Word>
[[gnu::always_inline]] inline RowTriple<Word> with_neighbours_in_row(Word row) {
  return {west_neighbour<1>(row, previous_word(row)), row, east_neighbour<1>(row, next_word(row))};
}

/// Images up to 32 or 64 pixels wide, in lanes of T.
template <class T>
struct PlainLanes {
  using Word = simd::batch<T, Architecture>;
  using Element = T;
  static constexpr Index kImages = static_cast<Index>(Word::size);
  static constexpr Index kElements = 1;  // per image

  [[gnu::always_inline]] static RowTriple<Word> with_neighbours(Word row) {
    return {row << 1, row, row >> 1};
  }
};

/// Images up to 128 pixels wide, each in two adjacent lanes.
struct PairedLanes {
  using Word = WordBatch;
  using Element = std::uint64_t;
  static constexpr Index kImages = static_cast<Index>(Word::size) / 2;
  static constexpr Index kElements = 2;

  [[gnu::always_inline]] static RowTriple<Word> with_neighbours(Word row) {
    return {west_neighbour<1>(row, previous_in_pair(row)), row,
            east_neighbour<1>(row, next_in_pair(row))};
  }
};

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
