// Distances in lanes, compiled for every ISA.
//
// Columns: one scan down and one up, 16 bits per pixel, vectorised by the compiler.
// Rows: min { (x - u)^2 + g(u)^2 } is searched from u = x outwards for a block of registers at a
// time. What lies k columns away costs at least k^2, so the search ends when no pixel of the block
// has more. Cost per register and step: 2 loads, 2 minima, 1 addition, 1 comparison; steps: the
// longest distance in the block. 16 bits suffice, as squares above that of kMaxSearch are never
// found: cut off at kFarSquared, they end the search like any others that are too long. A run of
// foreground pixels with a distance over kMaxSearch is left to the lower envelope, whose time does
// not depend on distances.
#include <algorithm>
#include <cmath>

#include "core/exported.hpp"
#include "distance/kernels.hpp"
#include "simd/vector.hpp"
#include "thinbench/distance.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

constexpr Index kLanes = static_cast<Index>(WideBatch::size);
constexpr Index kBlock = 32;  // pixels
constexpr Index kRegisters = kBlock / kLanes;
static_assert(kMaxSearch + kBlock <= DistanceRow::kMargin);

// The row above the image is far from background.
void columns(const ConstImageView& source, const VerticalDistances& vertical, Index first,
             Index last) {
  const Index count = last - first;
  std::uint16_t* above = nullptr;
  for (Index y = 0; y < source.height; ++y) {
    const std::uint8_t* const pixels = source.row(y) + first;
    std::uint16_t* const here = vertical.row(y) + first;
    for (Index x = 0; x < count; ++x) {
      const int distance = (above == nullptr ? kFarVertically - 1 : above[x]) + 1;
      here[x] = static_cast<std::uint16_t>(pixels[x] == 0 ? 0 : distance);
    }
    above = here;
  }
  for (Index y = source.height - 2; y >= 0; --y) {
    std::uint16_t* const here = vertical.row(y) + first;
    const std::uint16_t* const below = vertical.row(y + 1) + first;
    for (Index x = 0; x < count; ++x) {
      here[x] = std::min(here[x], static_cast<std::uint16_t>(below[x] + 1));
    }
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

/// The distances of a block, unless one is longer than the search.
bool search_block(const std::int16_t* squares, std::int32_t* distances) {
  WideBatch lowest[kRegisters];
  for (Index i = 0; i < kRegisters; ++i) {
    lowest[i] = WideBatch::load_unaligned(squares + i * kLanes);
  }
  for (int k = 1; k <= kMaxSearch; ++k) {
    const WideBatch square(static_cast<std::int16_t>(k * k));
    WideBatch highest = lowest[0];
    for (Index i = 1; i < kRegisters; ++i) highest = simd::max(highest, lowest[i]);
    if (!simd::any(highest > square)) {
      std::int16_t found[kBlock];
      for (Index i = 0; i < kRegisters; ++i) lowest[i].store_unaligned(found + i * kLanes);
      std::copy_n(found, kBlock, distances);
      return true;
    }
    for (Index i = 0; i < kRegisters; ++i) {
      const std::int16_t* const here = squares + i * kLanes;
      const WideBatch sides =
          simd::min(WideBatch::load_unaligned(here - k), WideBatch::load_unaligned(here + k));
      lowest[i] = simd::min(lowest[i], sides + square);
    }
  }
  return false;
}

/// Applies the lower envelope to the run of foreground pixels round x and returns its end. What is
/// beyond the background pixels on both sides is farther away than these.
Index envelope_of_run(const std::uint16_t* vertical, DistanceRow& memory, std::int32_t* distances,
                      Index x, Index width) {
  while (vertical[x] == 0) ++x;  // a block that is so far from background has foreground
  Index first = x;
  while (first > 0 && vertical[first] != 0) --first;
  while (x < width && vertical[x] != 0) ++x;
  const Index last = std::min(x + 1, width);
  envelope_row(vertical + first, memory, distances + first, last - first);
  return last;
}

void row(const std::uint16_t* vertical, DistanceRow& memory, std::int32_t* distances, Index width) {
  const std::int16_t* const squares = square_row(vertical, memory.squares(), width);
  Index x = 0;
  while (x < width) {
    std::int32_t found[kBlock];
    const bool is_whole = x + kBlock <= width;
    if (!search_block(squares + x, is_whole ? distances + x : found)) {
      x = envelope_of_run(vertical, memory, distances, x, width);
      continue;
    }
    if (!is_whole) std::copy_n(found, width - x, distances + x);
    x += kBlock;
  }
}

/// A root for each lane, as errno is not set here.
void roots(const std::int32_t* squares, double spacing, double* distances, Index width) {
  for (Index x = 0; x < width; ++x) {
    distances[x] = std::sqrt(static_cast<double>(squares[x])) * spacing;
  }
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const DistanceKernels Exported<DistanceKernels, kThisIsa>::kKernels = {&columns, &row,
                                                                                 &roots};

}  // namespace thinbench::detail
