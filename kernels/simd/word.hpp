// A word holds one pixel per bit or per byte lane and has the operators &, |, ^ and ~. Rules are
// written for any word type; engines choose one. This file has the other operations on words.
#pragma once

#include <cstdint>

#include "thinbench/image_view.hpp"

namespace thinbench::detail {

/// The truth table of a gate with three inputs, numbered as in vpternlog: bit 4a + 2b + c.
template <class Expression>
consteval std::uint8_t truth_table(Expression expression) {
  return static_cast<std::uint8_t>(expression(0xF0, 0xCC, 0xAA));
}

/// How a word type evaluates a gate with three inputs: by the gate's own expression, unless a
/// specialisation has one instruction for all 256 gates, `apply<truth_table>(a, b, c)`.
template <class Word>
struct TernaryGate {
  static constexpr bool kOneInstruction = false;
};

/// One gate with three inputs: `ternary(a, b, c, [](auto a, auto b, auto c) { return ...; })`.
/// Use as few two-input operations as possible: words without a three-input instruction execute
/// them.
template <class Word, class Expression>
[[gnu::always_inline]] constexpr Word ternary(Word a, Word b, Word c, Expression expression) {
  if constexpr (TernaryGate<Word>::kOneInstruction) {
    return TernaryGate<Word>::template apply<truth_table(Expression{})>(a, b, c);
  } else {
    return static_cast<Word>(expression(a, b, c));
  }
}

/// Memory access of a word type, and neighbours one pixel (west, east) and two pixels (west2,
/// east2) away. `Element` is the element type of planes.
template <class Word>
struct WordTraits;

/// 64 packed pixels. The west neighbour of bit i is bit i - 1, so `west` shifts towards high bits.
template <>
struct WordTraits<std::uint64_t> {
  using Element = std::uint64_t;
  static constexpr Index kElements = 1;
  static std::uint64_t load(const Element* from) { return *from; }
  static void store(Element* to, std::uint64_t word) { *to = word; }
  static std::uint64_t west(std::uint64_t centre, const Element* from) {
    return centre << 1 | from[-1] >> 63;
  }
  static std::uint64_t east(std::uint64_t centre, const Element* from) {
    return centre >> 1 | from[1] << 63;
  }
  static std::uint64_t west2(std::uint64_t centre, const Element* from) {
    return centre << 2 | from[-1] >> 62;
  }
  static std::uint64_t east2(std::uint64_t centre, const Element* from) {
    return centre >> 2 | from[1] << 62;
  }
  static std::uint64_t zero() { return 0; }
  static bool any(std::uint64_t word) { return word != 0; }
};

}  // namespace thinbench::detail
