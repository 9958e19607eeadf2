// Which pixels are nodes and which are lines, on words: see thinbench/graph.hpp for what these are.
#pragma once

#include "core/plane_view.hpp"
#include "simd/word.hpp"

namespace thinbench::detail {

/// Splits the pixels of rows [first, last) into node pixels and line pixels.
using SplitPixels = void (*)(const ConstBitPlaneView& image, const BitPlaneView& nodes,
                             const BitPlaneView& lines, Index first, Index last);

/// Compiled per ISA.
struct GraphKernels {
  SplitPixels split;
};

/// On 64-bit words.
extern const GraphKernels kBitpackedGraph;

/// A row of words, and its neighbours to the west and to the east.
template <class Word>
struct NeighbourRow {
  Word here;
  Word west;
  Word east;

  [[gnu::always_inline]] static NeighbourRow load(const std::uint64_t* from) {
    using Traits = WordTraits<Word>;
    const Word here = Traits::load(from);
    return {here, Traits::west(here, from), Traits::east(here, from)};
  }
};

/// For every pixel of a word, foreground or not, how many foreground pixels would be joined to it:
/// the bits of a number that is at most 4. And whether it completes a block of 2 x 2.
template <class Word>
struct Degrees {
  Word ones;
  Word twos;
  Word fours;
  Word in_block;
};

/// Of the four carries from ones to twos, at most two are set.
template <class Word>
[[gnu::always_inline]] constexpr Degrees<Word> degrees(const NeighbourRow<Word>& above,
                                                       const NeighbourRow<Word>& row,
                                                       const NeighbourRow<Word>& below) {
  const auto none_of = [](auto a, auto b, auto c) { return a & ~(b | c); };
  const auto parity = [](auto a, auto b, auto c) { return a ^ b ^ c; };
  const auto majority = [](auto a, auto b, auto c) { return (a & b) | (c & (a | b)); };
  const auto all = [](auto a, auto b, auto c) { return a & b & c; };
  const auto any = [](auto a, auto b, auto c) { return a | b | c; };
  const Word north_east = ternary(above.east, above.here, row.east, none_of);
  const Word north_west = ternary(above.west, above.here, row.west, none_of);
  const Word south_east = ternary(below.east, below.here, row.east, none_of);
  const Word south_west = ternary(below.west, below.here, row.west, none_of);

  const Word sides = ternary(above.here, below.here, row.east, parity);
  const Word side_carry = ternary(above.here, below.here, row.east, majority);
  const Word mixed = ternary(row.west, north_east, north_west, parity);
  const Word mixed_carry = ternary(row.west, north_east, north_west, majority);
  const Word corners = south_east ^ south_west;
  const Word corner_carry = south_east & south_west;
  const Word last_carry = ternary(sides, mixed, corners, majority);
  const Word twos = ternary(side_carry, mixed_carry, corner_carry, parity) ^ last_carry;
  const Word carry = ternary(side_carry, mixed_carry, corner_carry, any) | last_carry;

  const Word upper = ternary(above.here, above.east, row.east, all) |
                     ternary(above.here, above.west, row.west, all);
  const Word lower_east = ternary(below.here, below.east, row.east, all);
  const Word lower_west = ternary(below.here, below.west, row.west, all);
  return {.ones = ternary(sides, mixed, corners, parity),
          .twos = twos,
          .fours = carry & ~twos,
          .in_block = ternary(upper, lower_east, lower_west, any)};
}

/// Foreground pixels with exactly two joined neighbours, outside full blocks of 2 x 2.
template <class Word>
[[gnu::always_inline]] constexpr Word line_pixels(const Word& foreground, const Degrees<Word>& at) {
  const Word two = at.twos & ~at.ones;
  return ternary(foreground, two, at.in_block, [](auto a, auto b, auto c) { return a & b & ~c; });
}

/// The loop of every kernel.
template <class Word>
[[gnu::always_inline]] inline void split_pixels(const ConstBitPlaneView& image,
                                                const BitPlaneView& nodes,
                                                const BitPlaneView& lines, Index first,
                                                Index last) {
  using Traits = WordTraits<Word>;
  using Row = NeighbourRow<Word>;
  const Index words = (image.width + kWordBits - 1) / kWordBits;
  for (Index y = first; y < last; ++y) {
    for (Index i = 0; i < words; i += Traits::kElements) {
      const Row row = Row::load(image.row(y) + i);
      const Degrees<Word> at =
          degrees(Row::load(image.row(y - 1) + i), row, Row::load(image.row(y + 1) + i));
      const Word line = line_pixels(row.here, at);
      Traits::store(lines.row(y) + i, line);
      Traits::store(nodes.row(y) + i, row.here & ~line);
    }
  }
}

}  // namespace thinbench::detail
