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

/// `make.template operator()<Rows>()` for each layout that this ISA has, in an array by layout.
template <class T, class Make>
consteval void fill_layouts(T (&by_layout)[kLayouts], const Make& make) {
  const auto set = [&](Layout layout, T value) {
    by_layout[static_cast<std::size_t>(layout)] = value;
  };
  set(Layout::words, make.template operator()<PlaneRows<WordBatch>>());
  set(Layout::lanes_32, make.template operator()<RegisterRows<Lane<std::uint32_t>>>());
  set(Layout::lanes_64, make.template operator()<RegisterRows<Lane<std::uint64_t>>>());
  set(Layout::lanes_128, make.template operator()<RegisterRows<LanePair>>());
  [&]<bool holds_row>(std::bool_constant<holds_row>) {
    if constexpr (holds_row) set(Layout::row, make.template operator()<RegisterRows<WholeRow>>());
  }(std::bool_constant<kRegisterHoldsRow>{});
}

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
