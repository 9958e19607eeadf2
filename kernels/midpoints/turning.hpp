// How rows and diagonals become columns, and come back.
#pragma once

#include "simd/word.hpp"
#include "midpoints/unrolled.hpp"
#include "midpoints/work.hpp"

namespace thinbench::detail {

/// Batch `word` of a row that is turned by `pixels` towards the east; `ring` holds the row twice.
template <class Word>
[[gnu::always_inline]] inline Word turned_word(const std::uint64_t* ring, Index words, Index pixels,
                                               Index word) {
  using Traits = WordTraits<Word>;
  const std::uint64_t* from = ring + words - pixels / kWordBits + word;
  const int shift = static_cast<int>(pixels % kWordBits);
  return (Traits::load(from) << shift) | (Traits::load(from - 1) >> 1 >> (kWordBits - 1 - shift));
}

/// By how many pixels rows are turned, one after another, so that diagonals become columns.
class Turn {
 public:
  [[gnu::always_inline]] Turn(const Sheet& sheet, Direction direction, Index y)
      : around_(sheet.words * kWordBits),
        step_(direction == Direction::antidiagonals ? 1 : around_ - 1),
        pixels_(y % around_ * step_ % around_) {}

  [[nodiscard, gnu::always_inline]] Index there() const { return pixels_; }
  [[nodiscard, gnu::always_inline]] Index back() const {
    return pixels_ == 0 ? 0 : around_ - pixels_;
  }
  [[gnu::always_inline]] void move_down() {
    pixels_ += step_;
    if (pixels_ >= around_) pixels_ -= around_;
  }

 private:
  Index around_, step_, pixels_;
};

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
  [[gnu::always_inline]] void clear() {
    for (Index y = 0; y < kWordBits; ++y) set_row(y, Traits::zero());
  }

  /// The 64 rows of one block from and to words `stride` apart.
  [[gnu::always_inline]] void load_lane(Index lane, const std::uint64_t* from, Index stride) {
    for (Index y = 0; y < kWordBits; y += 8, from += 8 * stride) {
      unrolled<8>([&](auto i) __attribute__((always_inline)) {
        rows[(y + i) * kLanes + lane] = from[i * stride];
      });
    }
  }
  [[gnu::always_inline]] void store_lane(Index lane, std::uint64_t* to, Index stride) const {
    for (Index y = 0; y < kWordBits; y += 8, to += 8 * stride) {
      unrolled<8>([&](auto i) __attribute__((always_inline)) {
        to[i * stride] = rows[(y + i) * kLanes + lane];
      });
    }
  }

  /// Pixel (x, y) of each block becomes pixel (y, x): halves are exchanged, then quarters ... Eight
  /// rows stay in registers for three of the six steps.
  [[gnu::always_inline]] void transpose() {
    for (Index y = 0; y < 8; ++y) three_steps<8>(y);
    for (Index y = 0; y < kWordBits; y += 8) three_steps<1>(y);
  }

 private:
  /// Exchanges between rows y, y + apart ... y + 7 apart.
  template <int apart>
  [[gnu::always_inline]] void three_steps(Index y) {
    Word eight[8];
    unrolled<8>([&](auto i) __attribute__((always_inline)) { eight[i] = row(y + i * apart); });
    step<4, 4 * apart>(eight);
    step<2, 2 * apart>(eight);
    step<1, apart>(eight);
    unrolled<8>([&](auto i) __attribute__((always_inline)) { set_row(y + i * apart, eight[i]); });
  }

  /// The high parts, of `pixels` pixels each, of every row change places with the low parts of the
  /// row that is `places` places on.
  template <int places, int pixels>
  [[gnu::always_inline]] static void step(Word* eight) {
    constexpr std::uint64_t low = ~std::uint64_t{0} / ((std::uint64_t{1} << pixels) + 1);
    unrolled<8>([&](auto i) __attribute__((always_inline)) {
      if constexpr ((i & places) == 0) {
        Word& above = eight[i];
        Word& below = eight[i + places];
        const Word different = ((above >> pixels) ^ below) & Word(low);
        above = above ^ (different << pixels);
        below = below ^ different;
      }
    });
  }
};

}  // namespace thinbench::detail
