// Gates: what circuits are made of, as data and as operations on words.
#pragma once

#include <array>
#include <cstdint>

#include "simd/word.hpp"

namespace thinbench::detail {

inline constexpr int kWindowPixels = 9;

/// A gate with inputs a, b, c. Bit 4a + 2b + c of `function` is its value. An input is the number
/// of a value: 0 to 8 are the pixels of the window in raster order, 9 + i is the result of gate i
/// of the circuit.
struct Gate {
  std::uint8_t function;
  std::array<std::uint16_t, 3> inputs;

  friend bool operator==(const Gate&, const Gate&) = default;
};

/// The functions of a and b that every processor has. The gate's third input is its second.
inline constexpr std::uint8_t kAnd = 0xC0;
inline constexpr std::uint8_t kOr = 0xFC;
inline constexpr std::uint8_t kXor = 0x3C;
inline constexpr std::uint8_t kAndNot = 0x0C;  // ~a & b
inline constexpr std::uint8_t kNot = 0x0F;     // ~a

/// Whether words of this type have the gate as an operation.
template <class Word>
constexpr bool is_native(std::uint8_t function) {
  return TernaryGate<Word>::kOneInstruction || function == kAnd || function == kOr ||
         function == kXor || function == kAndNot || function == kNot;
}

/// The value of a native gate.
template <std::uint8_t function, class Word>
[[gnu::always_inline]] constexpr Word gate(Word a, Word b, Word c) {
  static_assert(is_native<Word>(function));
  if constexpr (TernaryGate<Word>::kOneInstruction) {
    return TernaryGate<Word>::template apply<function>(a, b, c);
  }
  if constexpr (function == kAnd) return static_cast<Word>(a & b);
  if constexpr (function == kOr) return static_cast<Word>(a | b);
  if constexpr (function == kXor) return static_cast<Word>(a ^ b);
  if constexpr (function == kAndNot) return static_cast<Word>(~a & b);
  if constexpr (function == kNot) return static_cast<Word>(~a);
}

}  // namespace thinbench::detail
