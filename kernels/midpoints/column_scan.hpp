// The midpoint scan on packed words of any length.
//
// A foreground pixel is the midpoint of its run if it is followed by as many pixels of the run as
// precede it, or by one more. Two scans over columns of words count these pixels: one down, and one
// up that also compares. This takes 5 gates per counter bit and row on any image, with 9 bits for
// runs of up to 510 pixels. Counts are stored once per 32 rows and recomputed from there, by 2 of
// the 5 gates.
//
// Rows become columns by transposing blocks of 64 x 64 pixels (6 x 32 exchanges of half rows per
// batch of blocks), diagonals by rotating row y of the image by y pixels (2 loads, 3 operations).
//
// Rejected without measurement: docs/experiments.md#midpoint-scan.
#pragma once

#include "midpoints/counter.hpp"
#include "midpoints/work.hpp"

namespace thinbench::detail {

/// A column of words: where to read pixels and write marks.
struct ScanColumn {
  const std::uint64_t* from;
  Index from_stride;
  std::uint64_t* to;
  Index to_stride;
  Index rows;
  std::uint64_t* checkpoints;
};

template <class Word, int bits>
struct MidpointScan {
  using Traits = WordTraits<Word>;
  using Counter = RunCounter<Word, bits>;
  static constexpr Index kCounterElements = bits * Traits::kElements;

  const ScanColumn& column;

  [[gnu::always_inline]] Word pixels(Index y) const {
    return Traits::load(column.from + y * column.from_stride);
  }
  [[gnu::always_inline]] std::uint64_t* checkpoint(Index first) const {
    return column.checkpoints + first / kChunkRows * kCounterElements;
  }

  [[gnu::always_inline]] void run() const {
    if (column.rows == 0) return;
    Counter counter;
    counter.clear();
    const Index last_chunk = (column.rows - 1) / kChunkRows * kChunkRows;
    for (Index first = 0; first < last_chunk; first += kChunkRows) {
      counter.store(checkpoint(first));
      for (Index y = first; y < first + kChunkRows; ++y) counter.count(pixels(y));
    }
    counter.store(checkpoint(last_chunk));
    counter.clear();
    for (Index first = last_chunk; first >= 0; first -= kChunkRows) mark_chunk(first, counter);
  }

  /// `following` counts pixels from below, up to the row after the chunk.
  [[gnu::always_inline]] void mark_chunk(Index first, Counter& following) const {
    alignas(64) std::uint64_t preceding[std::size_t{kChunkRows * kCounterElements}];
    const Index end = first + kChunkRows < column.rows ? first + kChunkRows : column.rows;
    Counter counter;
    counter.load(checkpoint(first));
    for (Index y = first; y < end; ++y) {
      counter.count(pixels(y));
      counter.store(preceding + (y - first) * kCounterElements);
    }
    for (Index y = end - 1; y >= first; --y) {
      const Word marks =
          midpoints(preceding + (y - first) * kCounterElements, pixels(y), following);
      Traits::store(column.to + y * column.to_stride, marks);
    }
  }

  /// Both counts include the pixel itself.
  [[gnu::always_inline]] static Word midpoints(const std::uint64_t* preceding, Word pixels,
                                               Counter& following) {
    const auto differs = [](auto any, auto a, auto b) { return any | (a ^ b); };
    Word not_one_more = Word(0);
    Word not_equal = Word(0);
    const Counter following_without_pixel = following;
    following.count(pixels);
    unrolled<bits>([&](auto i) __attribute__((always_inline)) {
      const Word bit = Traits::load(preceding + i * Traits::kElements);
      not_one_more = ternary(not_one_more, bit, following_without_pixel.bit[i], differs);
      not_equal = ternary(not_equal, bit, following.bit[i], differs);
    });
    return ternary(pixels, not_one_more, not_equal,
                   [](auto p, auto a, auto b) { return p & ~(a & b); });
  }
};

[[gnu::always_inline]] inline ScanColumn column_at(const ScanWork& work, Direction direction,
                                                   Index word) {
  const DirectionBuffer& buffer = work.buffer(direction);
  const PackedRows& pixels = buffer.pixels;
  const Index chunks = (pixels.rows + kChunkRows - 1) / kChunkRows;
  std::uint64_t* checkpoints = buffer.checkpoints + word * chunks * buffer.bits;
  if (direction == Direction::columns) {
    return {work.source.data + word, work.source.stride, work.target.data + word,
            work.target.stride,      work.source.height, checkpoints};
  }
  return {pixels.data + word, pixels.stride, pixels.data + word,
          pixels.stride,      pixels.rows,   checkpoints};
}

}  // namespace thinbench::detail
