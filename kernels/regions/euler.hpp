// The Euler number of a packed image by two population counts.
#pragma once

#include "thinbench/isa.hpp"
#include "image/plane_view.hpp"
#include "simd/word.hpp"

namespace thinbench::detail {

/// The part of the Euler number that pixels of rows [first, last) contribute, where a row beyond
/// the image counts too: the sum over rows [0, height] is the number.
using EulerKernel = std::int64_t (*)(const ConstBitPlaneView& image, Index first, Index last);

/// Exported for every ISA.
struct EulerKernels {
  EulerKernel eight;  // 8-connected objects, 4-connected holes
  EulerKernel four;   // 4-connected objects, 8-connected holes
};

/// 64 pixels a step, popcount of the compiler's baseline.
extern const EulerKernels kBitpackedEuler;

/// A table of the 16 quads of pixels, for byte planes.
using EulerQuads = std::int64_t (*)(const ConstBytePlaneView& image);
[[nodiscard]] std::int64_t euler_by_quads_8(const ConstBytePlaneView& image);
[[nodiscard]] std::int64_t euler_by_quads_4(const ConstBytePlaneView& image);

/// Pixels that add one to the number, and pixels that take one away; never both.
template <class Word>
struct EulerTerms {
  Word plus;
  Word minus;
};

/// With a pixel c and its neighbours to the west, north and north-west, where c may lie one column
/// or row beyond the image:
///   E8 = |!c !w !n nw| - |!c w n|        E4 = |c !w !n| - |c w n !nw|
struct EulerEight {
  template <class Word>
  [[gnu::always_inline]] static constexpr EulerTerms<Word> terms(Word c, Word w, Word n, Word nw) {
    const Word light = ternary(c, w, n, [](auto a, auto b, auto d) { return ~(a | b | d); });
    return {light & nw, ternary(c, w, n, [](auto a, auto b, auto d) { return ~a & b & d; })};
  }
};
struct EulerFour {
  template <class Word>
  [[gnu::always_inline]] static constexpr EulerTerms<Word> terms(Word c, Word w, Word n, Word nw) {
    const Word corner = ternary(w, n, nw, [](auto a, auto b, auto d) { return a & b & ~d; });
    return {ternary(c, w, n, [](auto a, auto b, auto d) { return a & ~(b | d); }), c & corner};
  }
};

/// Sums up `Counter` over rows [first, last): every kernel is this loop on another word.
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

/// Counts with the processor's own instruction where the compiler may use it.
struct WordCounter {
  std::int64_t total = 0;
  [[gnu::always_inline]] void add(const EulerTerms<std::uint64_t>& terms) {
    total += __builtin_popcountll(terms.plus) - __builtin_popcountll(terms.minus);
  }
  [[nodiscard]] [[gnu::always_inline]] std::int64_t sum() const { return total; }
};

}  // namespace thinbench::detail
