// How rows and diagonals become columns, and come back.
#pragma once

#include "core/word.hpp"
#include "scan/work.hpp"

namespace thinbench {

/// Batch `word` of a row that is turned by `pixels` towards the east; `ring` holds the row twice.
template <class Word>
[[gnu::always_inline]] inline Word turned_word(const std::uint64_t* ring, Index words, Index pixels,
                                               Index word) {
  using Traits = WordTraits<Word>;
  const std::uint64_t* from = ring + words - pixels / kWordBits + word;
  const int shift = static_cast<int>(pixels % kWordBits);
  return (Traits::load(from) << shift) | (Traits::load(from - 1) >> 1 >> (kWordBits - 1 - shift));
}

/// By how many pixels row y is turned, so that a diagonal becomes a column.
[[gnu::always_inline]] inline Index turn_of(Direction direction, Index y, Index words) {
  const Index around = words * kWordBits;
  const Index steps = y % around;
  return direction == Direction::kAntidiagonals || steps == 0 ? steps : around - steps;
}

[[gnu::always_inline]] inline Index turn_back_of(Direction direction, Index y, Index words) {
  const Index turn = turn_of(direction, y, words);
  return turn == 0 ? 0 : words * kWordBits - turn;
}

/// 64 rows of one batch: a block of 64 x 64 pixels a lane.
template <class Word>
struct Blocks {
  using Traits = WordTraits<Word>;
  static constexpr Index kLanes = Traits::kElements;

  alignas(64) std::uint64_t rows[std::size_t{kWordBits * kLanes}];

  [[gnu::always_inline]] Word row(Index y) const { return Traits::load(rows + y * kLanes); }
  [[gnu::always_inline]] void set_row(Index y, Word word) {
    Traits::store(rows + y * kLanes, word);
  }
  [[gnu::always_inline]] std::uint64_t& lane(Index y, Index lane) {
    return rows[y * kLanes + lane];
  }

  /// Pixel (x, y) of each block becomes pixel (y, x): halves are exchanged, then quarters ...
  [[gnu::always_inline]] void transpose() {
    std::uint64_t low = 0x00000000FFFFFFFF;
    for (int size = kWordBits / 2; size > 0; size /= 2, low ^= low << size) {
      for (Index y = 0; y < kWordBits; y = (y + size + 1) & ~Index{size}) exchange(y, size, low);
    }
  }

 private:
  /// The high parts of row y change places with the low parts of row y + size.
  [[gnu::always_inline]] void exchange(Index y, int size, std::uint64_t low) {
    const Word above = row(y);
    const Word below = row(y + size);
    const Word different = ((above >> size) ^ below) & Word(low);
    set_row(y, above ^ (different << size));
    set_row(y + size, below ^ different);
  }
};

}  // namespace thinbench
