// Distances in lanes, compiled per ISA.
//
// Columns: one scan down and one up, 16 bits per pixel, vectorised by the compiler, in strips that
// the second-level cache holds; a scan before them finds what they need to know of each other.
// Rows: min { (x - u)^2 + g(u)^2 } is searched from u = x outwards for a block of registers at a
// time. What lies k columns away costs at least k^2, so the search ends when no pixel of the block
// has more. Cost per register and step: 2 loads, 2 minima, 1 addition, 1 comparison; steps: the
// longest distance in the block. 16 bits suffice, as squares above that of kMaxSearch are never
// found: cut off at kFarSquared, they end the search like any others that are too long.
// A run of foreground pixels with a distance over kMaxSearch is searched in another way, whose time
// hardly depends on distances: columns between the nearest ones of two pixels are the only ones
// that matter to the pixels in between. Cost per pixel: about three additions and minima for all of
// kRunBlock pixels, and for each such block two searches of the columns that are left.
#include <algorithm>
#include <cmath>

#include "core/exported.hpp"
#include "distance/kernels.hpp"
#include "simd/vector.hpp"
#include "thinbench/distance.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

constexpr Index kWideLanes = static_cast<Index>(WideBatch::size);
constexpr Index kBlock = 32;  // pixels
constexpr Index kRegisters = kBlock / kWideLanes;
constexpr Index kRunBlock = DistanceRow::kRunBlock;
constexpr std::uint32_t kFarCost = std::uint32_t{1} << 31;  // more than any distance
static_assert(kMaxSearch + kBlock <= DistanceRow::kMargin);
static_assert(kMaxSearch >= kBlock);  // so a block whose search fails has no background

void edges(const ConstImageView& strip, const StripEdges& found) {
  std::uint16_t* const after_last = found.above;  // rows down to the last background pixel
  std::uint16_t* const first = found.below;
  std::fill_n(after_last, strip.width, std::uint16_t{0});
  std::fill_n(first, strip.width, kNoneInStrip);
  for (Index y = 0; y < strip.height; ++y) {
    const std::uint8_t* const pixels = strip.row(y);
    const auto row = static_cast<std::uint16_t>(y);
    const auto next = static_cast<std::uint16_t>(y + 1);
    for (Index x = 0; x < strip.width; ++x) {
      after_last[x] = std::max(after_last[x], pixels[x] == 0 ? next : std::uint16_t{0});
      first[x] = std::min(first[x], pixels[x] == 0 ? row : kNoneInStrip);
    }
  }
  const auto height = static_cast<std::uint16_t>(strip.height);
  for (Index x = 0; x < strip.width; ++x) {
    const int distance = after_last[x] == 0 ? kNoneInStrip : height - after_last[x];
    after_last[x] = static_cast<std::uint16_t>(distance);
  }
}

void columns(const ConstImageView& strip, const StripEdges& edges,
             const VerticalDistances& vertical) {
  const Index width = strip.width;
  const std::uint16_t* above = edges.above;
  for (Index y = 0; y < strip.height; ++y) {
    const std::uint8_t* const pixels = strip.row(y);
    std::uint16_t* const here = vertical.row(y);
    for (Index x = 0; x < width; ++x) {
      here[x] = static_cast<std::uint16_t>(pixels[x] == 0 ? 0 : above[x] + 1);
    }
    above = here;
  }
  const std::uint16_t* below = edges.below;
  for (Index y = strip.height - 1; y >= 0; --y) {
    std::uint16_t* const here = vertical.row(y);
    for (Index x = 0; x < width; ++x) {
      here[x] = std::min(here[x], static_cast<std::uint16_t>(below[x] + 1));
    }
    below = here;
  }
}

const std::int16_t* square_row(const std::uint16_t* vertical, std::int16_t* squares, Index width) {
  std::fill_n(squares - DistanceRow::kMargin, DistanceRow::kMargin, kFarSquared);
  for (Index x = 0; x < width; ++x) {
    const int distance = std::min(vertical[x], kTooFar);
    squares[x] = static_cast<std::int16_t>(distance * distance);
  }
  std::fill_n(squares + width, DistanceRow::kMargin, kFarSquared);
  return squares;
}

/// The distances of a block, unless one is longer than the search. `own` are the squares of the
/// block itself, but 0 beyond the end of the row.
bool search_block(const std::int16_t* squares, const std::int16_t* own, std::int32_t* distances) {
  WideBatch lowest[kRegisters];
  for (Index i = 0; i < kRegisters; ++i)
    lowest[i] = WideBatch::load_unaligned(own + i * kWideLanes);
  for (int k = 1; k <= kMaxSearch; ++k) {
    const WideBatch square(static_cast<std::int16_t>(k * k));
    WideBatch highest = lowest[0];
    for (Index i = 1; i < kRegisters; ++i) highest = simd::max(highest, lowest[i]);
    if (!simd::any(highest > square)) {
      std::int16_t found[kBlock];
      for (Index i = 0; i < kRegisters; ++i) lowest[i].store_unaligned(found + i * kWideLanes);
      std::copy_n(found, kBlock, distances);
      return true;
    }
    for (Index i = 0; i < kRegisters; ++i) {
      const std::int16_t* const here = squares + i * kWideLanes;
      const WideBatch sides =
          simd::min(WideBatch::load_unaligned(here - k), WideBatch::load_unaligned(here + k));
      lowest[i] = simd::min(lowest[i], sides + square);
    }
  }
  return false;
}

/// A run of foreground pixels with the background pixels on both sides, of which one may be
/// missing: what is beyond is farther away than these. Pixel x is (x - u)^2 + g(u)^2 from column u:
/// this is costs[u] + x^2 - 2 x u, modulo 2^32.
struct Run {
  const std::uint16_t* vertical;
  std::uint32_t* costs;
  Index width;
};

/// A column that is nearest to pixel x; one of [first, last] is. None is farther away than the
/// vertical distance.
Index nearest_column(const Run& run, Index x, Index first, Index last) {
  first = std::max(first, x - run.vertical[x]);
  last = std::min(last, x + run.vertical[x]);
  const auto square = static_cast<std::uint32_t>(x * x);
  const auto twice = static_cast<std::uint32_t>(2 * x);
  const auto begin = static_cast<std::uint32_t>(first), end = static_cast<std::uint32_t>(last) + 1;
  std::uint32_t lowest = UINT32_MAX;
  for (std::uint32_t u = begin; u < end; ++u) {
    lowest = std::min(lowest, run.costs[u] + square - twice * u);
  }
  std::uint32_t nearest = UINT32_MAX;
  for (std::uint32_t u = begin; u < end; ++u) {
    const bool is_higher = run.costs[u] + square - twice * u != lowest;
    nearest = std::min(nearest, u | (0 - static_cast<std::uint32_t>(is_higher)));
  }
  return nearest;
}

/// The distances of pixels [x, x + kRunBlock) from columns [first, last].
void search_run_block(const Run& run, Index x, Index first, Index last, std::int32_t* distances) {
  constexpr Index lanes = static_cast<Index>(Lanes32::size);
  constexpr Index registers = kRunBlock / lanes;
  Lanes32 lowest[registers], constant[registers], step[registers];
  for (Index i = 0; i < registers; ++i) {
    std::uint32_t constants[lanes], steps[lanes];
    for (Index lane = 0; lane < lanes; ++lane) {
      const Index pixel = x + i * lanes + lane;
      constants[lane] = static_cast<std::uint32_t>(pixel * pixel - 2 * pixel * first);
      steps[lane] = static_cast<std::uint32_t>(2 * pixel);
    }
    constant[i] = Lanes32::load_unaligned(constants);
    step[i] = Lanes32::load_unaligned(steps);
    lowest[i] = Lanes32(static_cast<std::uint32_t>(kNoBackground));
  }
  for (Index u = first; u <= last; ++u) {
    const Lanes32 cost(run.costs[u]);
    for (Index i = 0; i < registers; ++i) {
      lowest[i] = simd::min(lowest[i], cost + constant[i]);
      constant[i] = constant[i] - step[i];
    }
  }
  std::uint32_t found[kRunBlock];
  for (Index i = 0; i < registers; ++i) lowest[i].store_unaligned(found + i * lanes);
  for (Index i = 0; i < std::min(kRunBlock, run.width - x); ++i) {
    distances[x + i] = static_cast<std::int32_t>(found[i]);
  }
}

/// The farther right a pixel, the farther right its nearest column. So this is found for the first
/// pixel of every block, by halving, and limits the columns of those in between.
void search_run(const Run& run, std::int32_t* nearest, std::int32_t* distances) {
  const Index blocks = (run.width + kRunBlock - 1) / kRunBlock;
  Index half = 1;
  while (half < blocks) half *= 2;
  nearest[0] = 0;
  nearest[blocks] = static_cast<std::int32_t>(run.width - 1);
  for (half /= 2; half > 0; half /= 2) {
    for (Index block = half; block < blocks; block += 2 * half) {
      nearest[block] = static_cast<std::int32_t>(nearest_column(
          run, block * kRunBlock, nearest[block - half], nearest[std::min(block + half, blocks)]));
    }
  }
  for (Index block = 0; block < blocks; ++block) {
    search_run_block(run, block * kRunBlock, nearest[block], nearest[block + 1], distances);
  }
}

bool is_foreground(const std::uint16_t* vertical) {
  std::uint16_t lowest = UINT16_MAX;
  for (Index x = 0; x < kBlock; ++x) lowest = std::min(lowest, vertical[x]);
  return lowest > 0;
}

/// Searches the run of foreground pixels round x, which is one of them, and returns its end.
Index search_run_at(const std::uint16_t* vertical, DistanceRow& memory, std::int32_t* distances,
                    Index x, Index width) {
  Index first = x;
  while (first >= kBlock && is_foreground(vertical + first - kBlock)) first -= kBlock;
  while (first > 0 && vertical[first] != 0) --first;
  while (x + kBlock <= width && is_foreground(vertical + x)) x += kBlock;
  while (x < width && vertical[x] != 0) ++x;
  const Run run = {vertical + first, memory.costs(), std::min(x + 1, width) - first};
  for (Index u = 0; u < run.width; ++u) {
    const std::uint32_t distance = run.vertical[u];
    const std::uint32_t square = distance < kFarVertically ? distance * distance : kFarCost;
    run.costs[u] = square + static_cast<std::uint32_t>(u) * static_cast<std::uint32_t>(u);
  }
  search_run(run, memory.nearest(), distances + first);
  return first + run.width;
}

/// The same for the `count` pixels at the end of a row.
bool search_end(const std::int16_t* squares, std::int32_t* distances, Index count) {
  std::int16_t own[kBlock] = {};
  std::int32_t found[kBlock];
  std::copy_n(squares, count, own);
  if (!search_block(squares, own, found)) return false;
  std::copy_n(found, count, distances);
  return true;
}

void row(const std::uint16_t* vertical, DistanceRow& memory, std::int32_t* distances, Index width) {
  const std::int16_t* const squares = square_row(vertical, memory.squares(), width);
  Index x = 0;
  while (x < width) {
    const Index count = std::min(kBlock, width - x);
    const bool is_found = count == kBlock ? search_block(squares + x, squares + x, distances + x)
                                          : search_end(squares + x, distances + x, count);
    x = is_found ? x + count : search_run_at(vertical, memory, distances, x, width);
  }
}

bool has_above_one(const std::int32_t* squares) {
  std::int32_t highest = 0;
  for (Index x = 0; x < kBlock; ++x) highest = std::max(highest, squares[x]);
  return highest > 1;
}

/// 0 and 1, the most frequent squares, are their own roots. A root for each lane, as errno is not
/// set here.
void roots(const std::int32_t* squares, double spacing, double* distances, Index width) {
  Index x = 0;
  for (; x + kBlock <= width; x += kBlock) {
    if (has_above_one(squares + x)) {
      for (Index i = x; i < x + kBlock; ++i) {
        distances[i] = std::sqrt(static_cast<double>(squares[i])) * spacing;
      }
    } else {
      for (Index i = x; i < x + kBlock; ++i) distances[i] = squares[i] * spacing;
    }
  }
  for (; x < width; ++x) distances[x] = std::sqrt(static_cast<double>(squares[x])) * spacing;
}

/// Whole cache lines, as only these need not be read first.
void copy(const void* from, void* to, Index bytes) {
  constexpr Index line = 64;
  constexpr Index lanes = static_cast<Index>(ByteBatch::size);
  const auto* const source = static_cast<const std::uint8_t*>(from);
  auto* const target = static_cast<std::uint8_t*>(to);
  const Index before = static_cast<Index>(-reinterpret_cast<std::uintptr_t>(to) % line);
  Index i = std::min(before, bytes);
  std::copy_n(source, i, target);
  for (; i + line <= bytes; i += line) {
    for (Index lane = 0; lane < line; lane += lanes) {
      store_non_temporal(target + i + lane, ByteBatch::load_unaligned(source + i + lane));
    }
  }
  std::copy_n(source + i, bytes - i, target + i);
  finish_non_temporal_stores();
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const DistanceKernels Exported<DistanceKernels, kThisIsa>::kKernels = {
    &edges, &columns, &row, &roots, &copy};

}  // namespace thinbench::detail
