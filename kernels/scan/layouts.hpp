// How registers hold rows, and where the west and east neighbours of their pixels are: accesses to
// rows for the layouts in place. For ISA files only.
#pragma once

#include "scan/window.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

/// A register per row, whose pixels have all neighbours in the register. `Neighbours` gives them.
template <class Neighbours>
struct RegisterRows {
  using Word = WordBatch;
  static constexpr bool kInPlace = true;

  const std::uint64_t* data;  // row 0

  [[gnu::always_inline]] static RegisterRows at(const std::uint64_t* from, Index) { return {from}; }

  [[gnu::always_inline]] RowTriple<Word> row(Index y) const {
    return Neighbours::of(Word::load_aligned(data + y * static_cast<Index>(Word::size)));
  }

  template <class Rule>
  [[gnu::always_inline]] RowTriple<Word> features(Index, const RowTriple<Word>& above,
                                                  const RowTriple<Word>& here,
                                                  const RowTriple<Word>& below) const {
    return Neighbours::of(Rule::feature(cross(above.centre, here, below.centre)));
  }
};

/// A register that holds a whole row: pixels beyond both ends are background. `of` is a template
/// because not every ISA has registers of 512 bits.
struct WholeRow {
  template <class Word>
  [[gnu::always_inline]] static RowTriple<Word> of(Word row) {
    return {west_neighbour<1>(row, previous_word(row)), row,
            east_neighbour<1>(row, next_word(row))};
  }
};

/// Images up to 32 or 64 pixels wide, in lanes of T.
template <class T>
struct Lane {
  [[gnu::always_inline]] static RowTriple<WordBatch> of(WordBatch row) {
    const auto lanes = reinterpreted<BatchOf<T>>(row);
    return {reinterpreted<WordBatch>(lanes << 1), row, reinterpreted<WordBatch>(lanes >> 1)};
  }
};

/// Images up to 128 pixels wide, each in two adjacent 64-bit lanes.
struct LanePair {
  [[gnu::always_inline]] static RowTriple<WordBatch> of(WordBatch row) {
    return {west_neighbour<1>(row, previous_in_pair(row)), row,
            east_neighbour<1>(row, next_in_pair(row))};
  }
};

using RowsOfLanes32 = RegisterRows<Lane<std::uint32_t>>;
using RowsOfLanes64 = RegisterRows<Lane<std::uint64_t>>;
using RowsOfLanes128 = RegisterRows<LanePair>;

/// `make.template operator()<Rows>()` for whole rows; a default value on ISAs without Layout::row.
template <bool holds_row = kRegisterHoldsRow, class Make>
consteval auto for_whole_rows(const Make& make) {
  if constexpr (holds_row) {
    return make.template operator()<RegisterRows<WholeRow>>();
  } else {
    return decltype(make.template operator()<RowsOfLanes64>()){};
  }
}

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
