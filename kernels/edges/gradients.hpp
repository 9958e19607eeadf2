// The gradients of the edge operators on byte lanes: the operators of scan.hpp. For ISA files only.
// Each operator keeps partial results of preceding rows, so its first 2 * kReach results are
// invalid.
#pragma once

#include "edges/scan.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

/// The threshold for 16-bit magnitudes.
[[gnu::always_inline]] inline WideBatch scaled(int gradient_threshold, int scale) {
  return WideBatch(static_cast<std::int16_t>(gradient_threshold * scale));
}

/// Nonzero bytes where |gx| + |gy| exceeds the threshold.
[[gnu::always_inline]] inline ByteBatch sum_above(const Halves& gx, const Halves& gy,
                                                  WideBatch threshold) {
  return pack(excess(absolute(gx) + absolute(gy), threshold));
}

struct Roberts4In16Bits {
  static constexpr int kReach = 1;
  explicit Roberts4In16Bits(int gradient_threshold) : threshold(scaled(gradient_threshold, 2)) {}

  [[gnu::always_inline]] ByteBatch advance(const RowNeighbours<1>& row) {
    const ByteBatch result =
        sum_above(difference(here.at(0), row.at(1)), difference(here.at(1), row.at(0)), threshold);
    here = row;
    return result;
  }

  WideBatch threshold;
  RowNeighbours<1> here = {};
};

struct Roberts9In16Bits {
  static constexpr int kReach = 1;
  explicit Roberts9In16Bits(int gradient_threshold) : threshold(scaled(gradient_threshold, 2)) {}

  [[gnu::always_inline]] ByteBatch advance(const RowNeighbours<1>& row) {
    const ByteBatch result = sum_above(difference(above.at(-1), row.at(1)),
                                       difference(above.at(1), row.at(-1)), threshold);
    above = here;
    here = row;
    return result;
  }

  WideBatch threshold;
  RowNeighbours<1> above = {};
  RowNeighbours<1> here = {};
};

/// The average is rounded up, so average(a, b) > t is exactly a + b > 2 t.
struct Roberts4In8Bits {
  static constexpr int kReach = 1;
  explicit Roberts4In8Bits(int gradient_threshold)
      : threshold(static_cast<std::uint8_t>(gradient_threshold)) {}

  [[gnu::always_inline]] ByteBatch advance(const RowNeighbours<1>& row) {
    const ByteBatch mean =
        average(distance(here.at(0), row.at(1)), distance(here.at(1), row.at(0)));
    here = row;
    return excess(mean, threshold);
  }

  ByteBatch threshold;
  RowNeighbours<1> here = {};
};

struct Roberts9In8Bits {
  static constexpr int kReach = 1;
  explicit Roberts9In8Bits(int gradient_threshold)
      : threshold(static_cast<std::uint8_t>(gradient_threshold)) {}

  [[gnu::always_inline]] ByteBatch advance(const RowNeighbours<1>& row) {
    const ByteBatch mean =
        average(distance(above.at(-1), row.at(1)), distance(above.at(1), row.at(-1)));
    above = here;
    here = row;
    return excess(mean, threshold);
  }

  ByteBatch threshold;
  RowNeighbours<1> above = {};
  RowNeighbours<1> here = {};
};

struct PrewittIn16Bits {
  static constexpr int kReach = 1;
  explicit PrewittIn16Bits(int gradient_threshold) : threshold(scaled(gradient_threshold, 3)) {}

  [[gnu::always_inline]] ByteBatch advance(const RowNeighbours<1>& row) {
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

/// Shared by Sobel's and Mero-Vassy's operators. With the sums of the four blocks of 2 x 2 pixels
/// around p,
///   D1 = NE block - SW block,  D2 = SE block - NW block    (Mero-Vassy's gradient; p cancels)
///   gx = D1 + D2,  gy = D2 - D1                            (Sobel's gradient)
/// so Sobel's |gx| + |gy| is 2 max(|D1|, |D2|).
struct BlockDifferences {
  Halves d1;
  Halves d2;
};

struct BlockGradient {
  [[gnu::always_inline]] BlockDifferences advance(const RowNeighbours<1>& row) {
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
  Halves east_above = {};  // blocks one row above
  Halves west_above = {};
};

struct SobelIn16Bits {
  static constexpr int kReach = 1;
  explicit SobelIn16Bits(int gradient_threshold) : threshold(scaled(gradient_threshold, 2)) {}

  [[gnu::always_inline]] ByteBatch advance(const RowNeighbours<1>& row) {
    const BlockDifferences d = blocks.advance(row);
    return pack(excess(maximum(absolute(d.d1), absolute(d.d2)), threshold));
  }

  WideBatch threshold;
  BlockGradient blocks;
};

struct MeroVassyIn16Bits {
  static constexpr int kReach = 1;
  explicit MeroVassyIn16Bits(int gradient_threshold) : threshold(scaled(gradient_threshold, 4)) {}

  [[gnu::always_inline]] ByteBatch advance(const RowNeighbours<1>& row) {
    const BlockDifferences d = blocks.advance(row);
    return sum_above(d.d1, d.d2, threshold);
  }

  WideBatch threshold;
  BlockGradient blocks;
};

/// The 5 x 5 window split by its diagonals. Each new row adds to five windows. The weights in D1 of
/// the five pixels of a row, from west to east, are
///   top 0++++   -0+++   --0++   ---0+   ----0 bottom   (D2: the same from bottom to top)
struct MeroVassy5x5In16Bits {
  static constexpr int kReach = 2;
  explicit MeroVassy5x5In16Bits(int gradient_threshold)
      : threshold(scaled(gradient_threshold, 12)) {}

  [[gnu::always_inline]] ByteBatch advance(const RowNeighbours<2>& row) {
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
    d2[3] = four_west;  // is subtracted
    return result;
  }

  WideBatch threshold;
  Halves d1[4] = {};  // partial sums of the next four windows
  Halves d2[4] = {};
};

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
