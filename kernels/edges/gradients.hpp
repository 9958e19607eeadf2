// The gradients of the edge operators on lanes, row by row: what `sweep.hpp` calls an operator. For
// ISA files only. State of rows that came before is kept; only results after 2 reach rows count.
#pragma once

#include "edges/sweep.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

/// P1 times the operator's scale, against which 16-bit magnitudes stand.
[[gnu::always_inline]] inline WideBatch scaled(int p1, int scale) {
  return WideBatch(static_cast<std::int16_t>(p1 * scale));
}

/// |gx| + |gy| above the threshold, as bytes that are not 0.
[[gnu::always_inline]] inline ByteBatch sum_above(const Halves& gx, const Halves& gy,
                                                  WideBatch threshold) {
  return pack(excess(absolute(gx) + absolute(gy), threshold));
}

struct Roberts4In16Bits {
  static constexpr int kReach = 1;
  explicit Roberts4In16Bits(int p1) : threshold(scaled(p1, 2)) {}

  [[gnu::always_inline]] ByteBatch step(const Columns<1>& row) {
    const ByteBatch result =
        sum_above(difference(here.at(0), row.at(1)), difference(here.at(1), row.at(0)), threshold);
    here = row;
    return result;
  }

  WideBatch threshold;
  Columns<1> here = {};
};

struct Roberts9In16Bits {
  static constexpr int kReach = 1;
  explicit Roberts9In16Bits(int p1) : threshold(scaled(p1, 2)) {}

  [[gnu::always_inline]] ByteBatch step(const Columns<1>& row) {
    const ByteBatch result = sum_above(difference(above.at(-1), row.at(1)),
                                       difference(above.at(1), row.at(-1)), threshold);
    above = here;
    here = row;
    return result;
  }

  WideBatch threshold;
  Columns<1> above = {};
  Columns<1> here = {};
};

/// The average is rounded up: average(a, b) > P1 is a + b > 2 P1, exactly.
struct Roberts4In8Bits {
  static constexpr int kReach = 1;
  explicit Roberts4In8Bits(int p1) : threshold(static_cast<std::uint8_t>(p1)) {}

  [[gnu::always_inline]] ByteBatch step(const Columns<1>& row) {
    const ByteBatch mean =
        average(distance(here.at(0), row.at(1)), distance(here.at(1), row.at(0)));
    here = row;
    return excess(mean, threshold);
  }

  ByteBatch threshold;
  Columns<1> here = {};
};

struct Roberts9In8Bits {
  static constexpr int kReach = 1;
  explicit Roberts9In8Bits(int p1) : threshold(static_cast<std::uint8_t>(p1)) {}

  [[gnu::always_inline]] ByteBatch step(const Columns<1>& row) {
    const ByteBatch mean =
        average(distance(above.at(-1), row.at(1)), distance(above.at(1), row.at(-1)));
    above = here;
    here = row;
    return excess(mean, threshold);
  }

  ByteBatch threshold;
  Columns<1> above = {};
  Columns<1> here = {};
};

struct PrewittIn16Bits {
  static constexpr int kReach = 1;
  explicit PrewittIn16Bits(int p1) : threshold(scaled(p1, 3)) {}

  [[gnu::always_inline]] ByteBatch step(const Columns<1>& row) {
    const Halves across = difference(row.at(1), row.at(-1));
    const Halves along = sum(row.at(1), row.at(-1)) + widened(row.at(0));
    const ByteBatch result = sum_above(across_pair + across, along - along_above, threshold);
    across_pair = across_here + across;
    across_here = across;
    along_above = along_here;
    along_here = along;
    return result;
  }

  WideBatch threshold;
  Halves across_here = {};
  Halves across_pair = {};
  Halves along_here = {};
  Halves along_above = {};
};

/// What Sobel's operator and Mero-Vassy's have in common. With the sums of the four blocks of 2 x 2
/// pixels round p,
///   D1 = NE block - SW block,  D2 = SE block - NW block    (Mero-Vassy's two halves; p cancels)
///   gx = D1 + D2,  gy = D2 - D1                            (Sobel's)
/// so that Sobel's |gx| + |gy| is 2 max(|D1|, |D2|).
struct BlockDifferences {
  Halves d1;
  Halves d2;
};

struct Blocks {
  [[gnu::always_inline]] BlockDifferences step(const Columns<1>& row) {
    const Halves east = sum(row.at(0), row.at(1));
    const Halves west = sum(row.at(-1), row.at(0));
    const Halves east_block = east_here + east;
    const Halves west_block = west_here + west;
    const BlockDifferences result = {east_above - west_block, east_block - west_above};
    east_here = east;
    west_here = west;
    east_above = east_block;
    west_above = west_block;
    return result;
  }

  Halves east_here = {};
  Halves west_here = {};
  Halves east_above = {};  // blocks of the rows above
  Halves west_above = {};
};

struct SobelIn16Bits {
  static constexpr int kReach = 1;
  explicit SobelIn16Bits(int p1) : threshold(scaled(p1, 2)) {}

  [[gnu::always_inline]] ByteBatch step(const Columns<1>& row) {
    const BlockDifferences d = blocks.step(row);
    return pack(excess(largest(absolute(d.d1), absolute(d.d2)), threshold));
  }

  WideBatch threshold;
  Blocks blocks;
};

struct MeroVassyIn16Bits {
  static constexpr int kReach = 1;
  explicit MeroVassyIn16Bits(int p1) : threshold(scaled(p1, 4)) {}

  [[gnu::always_inline]] ByteBatch step(const Columns<1>& row) {
    const BlockDifferences d = blocks.step(row);
    return sum_above(d.d1, d.d2, threshold);
  }

  WideBatch threshold;
  Blocks blocks;
};

/// The window of 5 x 5 split by its diagonals, summed up while rows come in: a row adds to five
/// windows. Over a row's pixels a b c d e, from west to east, the weights in D1 are
///   top 0++++   -0+++   --0++   ---0+   ----0 bottom   (D2: the same from bottom to top)
struct MeroVassy5x5In16Bits {
  static constexpr int kReach = 2;
  explicit MeroVassy5x5In16Bits(int p1) : threshold(scaled(p1, 12)) {}

  [[gnu::always_inline]] ByteBatch step(const Columns<2>& row) {
    const Halves c = widened(row.at(0));
    const Halves inner = sum(row.at(-1), row.at(1)) + c;
    const Halves outer_difference = difference(row.at(2), row.at(-2));
    const Halves four_east = inner + widened(row.at(2));
    const Halves four_west = inner + widened(row.at(-2));
    const Halves three_east = c + widened(row.at(1)) + outer_difference;
    const Halves three_west = outer_difference - (c + widened(row.at(-1)));
    const Halves two = outer_difference + difference(row.at(1), row.at(-1));
    const ByteBatch result = sum_above(d1[0] - four_west, d2[0] + four_east, threshold);
    d1[0] = d1[1] + three_west;
    d1[1] = d1[2] + two;
    d1[2] = d1[3] + three_east;
    d1[3] = four_east;
    d2[0] = d2[1] + three_east;
    d2[1] = d2[2] + two;
    d2[2] = three_west - d2[3];
    d2[3] = four_west;  // to be taken away
    return result;
  }

  WideBatch threshold;
  Halves d1[4] = {};  // of the next four windows, so far
  Halves d2[4] = {};
};

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
