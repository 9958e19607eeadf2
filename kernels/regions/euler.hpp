// The Euler number of a packed image by two population counts.
#pragma once

#include "core/exported.hpp"
#include "core/plane_view.hpp"
#include "simd/word.hpp"

namespace thinbench::detail {

/// The contribution of rows [first, last). The Euler number is the sum over rows 0 to `height`, one
/// row past the image.
using EulerKernel = std::int64_t (*)(const ConstBitPlaneView& image, Index first, Index last);

/// By connectivity of the objects; the background has the other one.
struct EulerKernels {
  EulerKernel eight;
  EulerKernel four;
};
template <>
inline constexpr Features kGainsFrom<EulerKernels> = ~Features{0};

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

}  // namespace thinbench::detail
