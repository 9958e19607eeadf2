// Counters of run lengths: one counter per pixel, bit i of all counters in word i.
#pragma once

#include <utility>

#include "simd/word.hpp"

namespace thinbench::detail {

/// Calls `body` with integral constants 0 to count - 1, so that arrays can live in registers.
template <int count, class Body>
[[gnu::always_inline]] inline void unrolled(const Body& body) {
  [&]<int... i>(std::integer_sequence<int, i...>) __attribute__((always_inline)) {
    (body(std::integral_constant<int, i>{}), ...);
  }
  (std::make_integer_sequence<int, count>{});
}

/// The second feedback tap, counted from 1; the first is the last bit. The polynomial
/// x^bits + x^(bits - tap) + 1 is primitive: from 0 the counter takes every state except all ones.
constexpr int feedback_tap(int bits) {
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

/// A linear-feedback shift register. It takes each state once, so equal counts are equal states,
/// and it has no carry chain. Counting costs one AND per bit, plus one gate.
template <class Word, int bits>
struct RunCounter {
  Word bit[std::size_t{bits}];

  [[gnu::always_inline]] void clear() {
    unrolled<bits>([&](auto i) __attribute__((always_inline)) { bit[i] = Word(0); });
  }

  /// Increments foreground lanes, resets background lanes to 0.
  [[gnu::always_inline]] void count(Word foreground) {
    const Word feedback = ternary(bit[bits - 1], bit[feedback_tap(bits) - 1], foreground,
                                  [](auto a, auto b, auto f) { return ~(a ^ b) & f; });
    unrolled<bits - 1>([&](auto i) __attribute__((always_inline)) {
      constexpr int to = bits - 1 - i;
      bit[to] = bit[to - 1] & foreground;
    });
    bit[0] = feedback;
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
