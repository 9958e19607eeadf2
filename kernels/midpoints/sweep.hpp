// The scanning skeleton on packed words: one engine for words of any length.
//
// A dark pixel is the centre of its run where as many dark pixels lie before it as behind it, or
// one more behind it. Two sweeps over columns of words count them: down, and up again with the
// comparison. Counting and comparing take 5 gates a counter bit and row, 9 bits for runs of up to
// 510 pixels, whatever the picture shows; marking run by run would be a jump that depends on the
// picture for each of thousands of runs. Counts are stored once in 32 rows and calculated again
// from there (2 of the 5 gates): all counts of an image would not stay in the first-level cache.
//
// Rows become columns by transposing blocks of 64 x 64 pixels (6 x 32 exchanges of half rows a
// batch of blocks), diagonals by turning row y of the image by y pixels round a ring (2 loads, 3
// operations).
#pragma once

#include "midpoints/counter.hpp"
#include "midpoints/work.hpp"

namespace thinbench::detail {

/// A column of words: where pixels come from and marks go to.
struct ScanColumn {
  const std::uint64_t* from;
  Index from_stride;
  std::uint64_t* to;
  Index to_stride;
  Index rows;
  std::uint64_t* checkpoints;
};

template <class Word, int bits>
struct ColumnSweep {
  using Traits = WordTraits<Word>;
  using Counter = RunCounter<Word, bits>;
  static constexpr Index kCounterElements = bits * Traits::kElements;

  const ScanColumn& column;

  [[gnu::always_inline]] Word dark(Index y) const {
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
      for (Index y = first; y < first + kChunkRows; ++y) counter.count(dark(y));
    }
    counter.store(checkpoint(last_chunk));
    counter.clear();
    for (Index first = last_chunk; first >= 0; first -= kChunkRows) mark_chunk(first, counter);
  }

  /// `behind` counts from below and has reached the row after the chunk.
  [[gnu::always_inline]] void mark_chunk(Index first, Counter& behind) const {
    alignas(64) std::uint64_t before[std::size_t{kChunkRows * kCounterElements}];
    const Index end = first + kChunkRows < column.rows ? first + kChunkRows : column.rows;
    Counter counter;
    counter.load(checkpoint(first));
    for (Index y = first; y < end; ++y) {
      counter.count(dark(y));
      counter.store(before + (y - first) * kCounterElements);
    }
    for (Index y = end - 1; y >= first; --y) {
      const Word mark = centres(before + (y - first) * kCounterElements, dark(y), behind);
      Traits::store(column.to + y * column.to_stride, mark);
    }
  }

  /// Both counts include the pixel itself.
  [[gnu::always_inline]] static Word centres(const std::uint64_t* before, Word dark,
                                             Counter& behind) {
    const auto differs = [](auto all, auto a, auto b) { return all | (a ^ b); };
    Word one_more = Word(0);  // where there is not one more behind
    Word as_many = Word(0);   // where there are not as many
    const Counter short_of_it = behind;
    behind.count(dark);
    unrolled<bits>([&](auto i) __attribute__((always_inline)) {
      const Word bit = Traits::load(before + i * Traits::kElements);
      one_more = ternary(one_more, bit, short_of_it.bit[i], differs);
      as_many = ternary(as_many, bit, behind.bit[i], differs);
    });
    return ternary(dark, one_more, as_many, [](auto d, auto a, auto b) { return d & ~(a & b); });
  }
};

[[gnu::always_inline]] inline ScanColumn column_at(const ScanWork& work, Direction direction,
                                                   Index word) {
  const Turned& turned = work.turned[static_cast<int>(direction)];
  const Index chunks = (turned.sheet.rows + kChunkRows - 1) / kChunkRows;
  std::uint64_t* checkpoints = turned.checkpoints + word * chunks * turned.bits;
  if (direction == Direction::columns) {
    return {work.source.data + word, work.source.stride, work.target.data + word,
            work.target.stride,      work.source.height, checkpoints};
  }
  const Sheet& sheet = turned.sheet;
  return {sheet.data + word, sheet.stride, sheet.data + word,
          sheet.stride,      sheet.rows,   checkpoints};
}

}  // namespace thinbench::detail
