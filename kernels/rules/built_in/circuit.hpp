// Rules as circuits of gates: data that becomes the same instructions as an expression.
#pragma once

#include <array>
#include <cstddef>

#include "rules/built_in/neighbourhood.hpp"
#include "simd/gate.hpp"

namespace thinbench::detail {

/// Gates read earlier gates only, and the last one is the new pixel.
template <std::size_t count>
struct Circuit {
  int search_effort;  // the SearchEffort that finds it, in millions, or kByHand
  std::array<Gate, count> gates;
};
inline constexpr int kByHand = 0;

/// The circuits of a sub-iteration, in circuits.hpp: for words with three-input gates, and for all
/// others. The second has only gates that every word has.
template <BuiltInRule rule, int sub>
inline constexpr Circuit<0> kThreeInputCircuit = {};
template <BuiltInRule rule, int sub>
inline constexpr Circuit<0> kTwoInputCircuit = {};

/// The pixels and the first `count` gates of a circuit. A chain, as GCC inlines less around an
/// array.
template <const auto& circuit, std::size_t count, class Word>
struct Values {
  const Values<circuit, count - 1, Word>& earlier;
  Word last;

  template <std::size_t number>
  [[gnu::always_inline]] constexpr Word get() const {
    if constexpr (number == kWindowPixels + count - 1) {
      return last;
    } else {
      return earlier.template get<number>();
    }
  }
};

template <const auto& circuit, class Word>
struct Values<circuit, 0, Word> {
  using Pixels = Neighbourhood<Word>;
  const Pixels& pixels;

  template <std::size_t number>
  [[gnu::always_inline]] constexpr Word get() const {
    constexpr Word Pixels::*members[kWindowPixels] = {&Pixels::n3, &Pixels::n2, &Pixels::n1,
                                                      &Pixels::n4, &Pixels::p,  &Pixels::n0,
                                                      &Pixels::n5, &Pixels::n6, &Pixels::n7};
    constexpr Word Pixels::*member = members[number];
    return pixels.*member;
  }
};

template <const auto& circuit, std::size_t count, class Word>
[[gnu::always_inline]] constexpr Word output_of(const Values<circuit, count, Word>& values) {
  if constexpr (count == circuit.gates.size()) {
    return values.last;
  } else {
    constexpr Gate next = circuit.gates[count];
    const Word value = gate<next.function>(values.template get<next.inputs[0]>(),
                                           values.template get<next.inputs[1]>(),
                                           values.template get<next.inputs[2]>());
    return output_of<circuit, count + 1, Word>({values, value});
  }
}

/// The new pixel, by the circuit that suits the word type.
template <BuiltInRule rule, int sub, class Word>
[[gnu::always_inline]] constexpr Word by_circuit(const Neighbourhood<Word>& n) {
  if constexpr (TernaryGate<Word>::kOneInstruction) {
    return output_of<kThreeInputCircuit<rule, sub>, 0, Word>({n});
  } else {
    return output_of<kTwoInputCircuit<rule, sub>, 0, Word>({n});
  }
}

}  // namespace thinbench::detail
