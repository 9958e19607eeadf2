// Transposition and rotation: rows and diagonals to columns, and back.
#pragma once

#include "midpoints/counter.hpp"
#include "midpoints/work.hpp"
#include "simd/word.hpp"

namespace thinbench::detail {

/// Batch `word` of a row that is rotated left, that is, to the east, by `pixels`. `ring` holds the
/// row twice.
template <class Word>
[[gnu::always_inline]] inline Word rotl_row(const std::uint64_t* ring, Index words, Index pixels,
                                            Index word) {
  using Traits = WordTraits<Word>;
  const std::uint64_t* from = ring + words - pixels / kWordBits + word;
  const int shift = static_cast<int>(pixels % kWordBits);
  return (Traits::load(from) << shift) | (Traits::load(from - 1) >> 1 >> (kWordBits - 1 - shift));
}

/// Rotation in a register; specialised where a word holds a whole row.
template <class Word, Isa isa>
struct RegisterRotl {
  static constexpr bool kAvailable = false;
};

/// The rotation of each row that turns diagonals into columns.
class DiagonalRotation {
 public:
  [[gnu::always_inline]] DiagonalRotation(const PackedRows& rows, Direction direction, Index y)
      : ring_pixels_(rows.words * kWordBits),
        per_row_(direction == Direction::antidiagonals ? 1 : ring_pixels_ - 1),
        pixels_(y % ring_pixels_ * per_row_ % ring_pixels_) {}

  [[nodiscard, gnu::always_inline]] Index forward() const { return pixels_; }
  [[nodiscard, gnu::always_inline]] Index back() const {
    return pixels_ == 0 ? 0 : ring_pixels_ - pixels_;
  }
  [[gnu::always_inline]] void move_down() {
    pixels_ += per_row_;
    if (pixels_ >= ring_pixels_) pixels_ -= ring_pixels_;
  }

 private:
  Index ring_pixels_, per_row_, pixels_;
};

/// 64 rows of one batch: a block of 64 x 64 pixels in each lane.
template <class Word>
struct TransposableRows {
  using Traits = WordTraits<Word>;

  alignas(64) std::uint64_t rows[std::size_t{kWordBits * Traits::kElements}];

  [[gnu::always_inline]] Word row(Index y) const {
    return Traits::load(rows + y * Traits::kElements);
  }
  [[gnu::always_inline]] void set_row(Index y, Word word) {
    Traits::store(rows + y * Traits::kElements, word);
  }
  [[gnu::always_inline]] void clear() {
    for (Index y = 0; y < kWordBits; ++y) set_row(y, Traits::zero());
  }

  /// Copies the 64 rows of one block from or to words `stride` apart.
  [[gnu::always_inline]] void load_lane(Index lane, const std::uint64_t* from, Index stride) {
    for (Index y = 0; y < kWordBits; y += 8, from += 8 * stride) {
      unrolled<8>([&](auto i) __attribute__((always_inline)) {
        rows[(y + i) * Traits::kElements + lane] = from[i * stride];
      });
    }
  }
  [[gnu::always_inline]] void store_lane(Index lane, std::uint64_t* to, Index stride) const {
    for (Index y = 0; y < kWordBits; y += 8, to += 8 * stride) {
      unrolled<8>([&](auto i) __attribute__((always_inline)) {
        to[i * stride] = rows[(y + i) * Traits::kElements + lane];
      });
    }
  }

  /// Pixel (x, y) of each block becomes pixel (y, x), by exchanging halves, then quarters, and so
  /// on. Eight rows stay in registers for three of the six stages.
  [[gnu::always_inline]] void transpose() {
    for (Index y = 0; y < 8; ++y) three_stages<8>(y);
    for (Index y = 0; y < kWordBits; y += 8) three_stages<1>(y);
  }

 private:
  /// Three stages on rows y, y + distance, ..., y + 7 distance.
  template <int distance>
  [[gnu::always_inline]] void three_stages(Index y) {
    Word eight[8];
    unrolled<8>([&](auto i) __attribute__((always_inline)) { eight[i] = row(y + i * distance); });
    exchange<4, 4 * distance>(eight);
    exchange<2, 2 * distance>(eight);
    exchange<1, distance>(eight);
    unrolled<8>([&](auto i)
                    __attribute__((always_inline)) { set_row(y + i * distance, eight[i]); });
  }

  /// Exchanges the high parts of row i, of `pixels` pixels each, with the low parts of row
  /// i + `offset`.
  template <int offset, int pixels>
  [[gnu::always_inline]] static void exchange(Word* eight) {
    constexpr std::uint64_t low = ~std::uint64_t{0} / ((std::uint64_t{1} << pixels) + 1);
    unrolled<8>([&](auto i) __attribute__((always_inline)) {
      if constexpr ((i & offset) == 0) {
        Word& above = eight[i];
        Word& below = eight[i + offset];
        const Word different = ((above >> pixels) ^ below) & Word(low);
        above = above ^ (different << pixels);
        below = below ^ different;
      }
    });
  }
};

}  // namespace thinbench::detail
