// The Euler number of a packed image by two population counts.
#pragma once

#include "core/plane_view.hpp"
#include "simd/word.hpp"
#include "thinbench/isa.hpp"

namespace thinbench::detail {

/// The contribution of rows [first, last). The Euler number is the sum over rows 0 to `height`, one
/// row past the image.
using EulerKernel = std::int64_t (*)(const ConstBitPlaneView& image, Index first, Index last);

/// Kernels by connectivity of the objects; the background has the other connectivity.
template <class Kernel>
struct EulerPair {
  Kernel eight;
  Kernel four;
};

/// Compiled for every ISA.
using EulerKernels = EulerPair<EulerKernel>;

/// On 64-bit words, with the baseline's population count.
extern const EulerKernels kBitpackedEuler;

/// Pixels that add 1 to the Euler number, and pixels that subtract 1; disjoint.
template <class Word>
struct EulerTerms {
  Word plus;
  Word minus;
};

/// For a pixel c, which may lie one column or row past the image, and its neighbours w, n and nw:
///   E8 = |!c !w !n nw| - |!c w n|        E4 = |c !w !n| - |c w n !nw|
struct EulerEight {
  template <class Word>
  [[gnu::always_inline]] static constexpr EulerTerms<Word> terms(Word c, Word w, Word n, Word nw) {
    const Word none = ternary(c, w, n, [](auto a, auto b, auto d) { return ~(a | b | d); });
    return {none & nw, ternary(c, w, n, [](auto a, auto b, auto d) { return ~a & b & d; })};
  }
};
struct EulerFour {
  template <class Word>
  [[gnu::always_inline]] static constexpr EulerTerms<Word> terms(Word c, Word w, Word n, Word nw) {
    const Word corner = ternary(w, n, nw, [](auto a, auto b, auto d) { return a & b & ~d; });
    return {ternary(c, w, n, [](auto a, auto b, auto d) { return a & ~(b | d); }), c & corner};
  }
};

/// The loop of every kernel, for any word type.
template <class Connectivity, class Word, class Counter>
[[gnu::always_inline]] inline std::int64_t sum_euler(const ConstBitPlaneView& image, Index first,
                                                     Index last) {
  using Traits = WordTraits<Word>;
  const Index words = image.width / kWordBits + 1;
  Counter counter;
  for (Index y = first; y < last; ++y) {
    const std::uint64_t* row = image.row(y);
    const std::uint64_t* above = image.row(y - 1);
    for (Index i = 0; i < words; i += Traits::kElements) {
      const Word c = Traits::load(row + i);
      const Word n = Traits::load(above + i);
      counter.add(Connectivity::terms(c, Traits::west(c, row + i), n, Traits::west(n, above + i)));
    }
  }
  return counter.sum();
}

/// Compiles to popcnt where the ISA has it.
struct WordCounter {
  std::int64_t total = 0;
  [[gnu::always_inline]] void add(const EulerTerms<std::uint64_t>& terms) {
    total += __builtin_popcountll(terms.plus) - __builtin_popcountll(terms.minus);
  }
  [[nodiscard]] [[gnu::always_inline]] std::int64_t sum() const { return total; }
};

}  // namespace thinbench::detail
