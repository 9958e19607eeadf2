// How many dark pixels in a row: a counter a pixel, its bits in `bits` words.
#pragma once

#include "simd/word.hpp"
#include "midpoints/unrolled.hpp"

namespace thinbench::detail {

/// The second place, from 1, whose bit is fed back; the first is the last. x^bits + x^(bits -
/// place)
/// + 1 is primitive: all 2^bits - 1 states other than all ones follow each other from 0.
constexpr int feedback_place(int bits) {
  switch (bits) {
    case 7:
      return 6;
    case 9:
      return 5;
    case 11:
      return 9;
    case 15:
      return 14;
    default:
      return 38;  // 41
  }
}

/// A shift register with feedback: it takes each state once, which is all that comparing two
/// counts for equality needs, and has no chain of carries. A step costs one AND a bit, and one
/// gate.
template <class Word, int bits>
struct RunCounter {
  Word bit[std::size_t{bits}];

  [[gnu::always_inline]] void clear() {
    unrolled<bits>([&](auto i) __attribute__((always_inline)) { bit[i] = Word(0); });
  }

  /// One more where dark, 0 where light.
  [[gnu::always_inline]] void count(Word dark) {
    const Word fed = ternary(bit[bits - 1], bit[feedback_place(bits) - 1], dark,
                             [](auto a, auto b, auto d) { return ~(a ^ b) & d; });
    unrolled<bits - 1>([&](auto i) __attribute__((always_inline)) {
      constexpr int to = bits - 1 - i;
      bit[to] = bit[to - 1] & dark;
    });
    bit[0] = fed;
  }

  template <class Element>
  [[gnu::always_inline]] void load(const Element* from) {
    using Traits = WordTraits<Word>;
    unrolled<bits>([&](auto i) __attribute__((always_inline)) {
      bit[i] = Traits::load(from + i * Traits::kElements);
    });
  }

  template <class Element>
  [[gnu::always_inline]] void store(Element* to) const {
    using Traits = WordTraits<Word>;
    unrolled<bits>([&](auto i) __attribute__((always_inline)) {
      Traits::store(to + i * Traits::kElements, bit[i]);
    });
  }
};

}  // namespace thinbench::detail
