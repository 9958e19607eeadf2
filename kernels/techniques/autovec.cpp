// The published arithmetic on bytes 0 and 1, written for the compiler's vectoriser: whole rows, no
// branches, no early exit. Compiled per ISA at -O3, as the baseline for hand-written SIMD.
#include "core/exported.hpp"
#include "techniques/passes.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

using Bytes = const std::uint8_t* __restrict;

[[gnu::always_inline]] inline Neighbourhood<std::uint8_t> neighbourhood_at(Bytes above, Bytes here,
                                                                           Bytes below, Index x) {
  return {here[x],     here[x + 1],  above[x + 1], above[x],    above[x - 1],
          here[x - 1], below[x - 1], below[x],     below[x + 1]};
}

/// The features of three rows of a strip, for two-stage rules.
struct FeatureStrip {
  static constexpr Index kPixels = 64;
  static constexpr Index kStride = 128;
  std::uint8_t rows[3][kStride];  // pixel x of the strip is at 1 + x

  template <class Rule>
  [[gnu::always_inline]] void fill(int row, const std::uint8_t* here, Index stride) {
    Bytes above = here - stride;
    Bytes below = here + stride;
    std::uint8_t* __restrict out = rows[row];
    for (Index x = -1; x <= kPixels; ++x) {
      out[1 + x] =
          Rule::feature(Cross<std::uint8_t>{here[x], here[x + 1], above[x], here[x - 1], below[x]});
    }
  }
};

/// The rule's published arithmetic or, without one, its expression.
template <class Rule, int sub, class... Neighbourhoods>
[[gnu::always_inline]] inline std::uint8_t new_pixel(const Neighbourhoods&... at) {
  if constexpr (requires { Rule::template published<sub>(at...); }) {
    return Rule::template published<sub>(at...);
  } else {
    return static_cast<std::uint8_t>(Rule{}.template next<sub>(at...) & 1);
  }
}

/// Writes `next(x)` for `count` pixels of a row. Returns nonzero if a pixel changed. `fixed`: see
/// Pass.
template <class Next>
[[gnu::always_inline]] inline std::uint8_t write_pixels(const std::uint8_t* fixed, Bytes here,
                                                        std::uint8_t* __restrict target,
                                                        Index count, const Next& next) {
  std::uint8_t changed = 0;
  const auto write = [&](Index x, std::uint8_t pixel) __attribute__((always_inline)) {
    target[x] = pixel;
    changed = static_cast<std::uint8_t>(changed | (pixel ^ here[x]));
  };
  if (fixed == nullptr) {
    for (Index x = 0; x < count; ++x) write(x, next(x));
  } else {
    for (Index x = 0; x < count; ++x) {
      write(x, static_cast<std::uint8_t>(next(x) | (here[x] & fixed[x])));
    }
  }
  return changed;
}

struct Autovec {
  using Element = std::uint8_t;
  template <class Rule, int sub>
  static std::uint64_t pass(const std::uint8_t* fixed, const ConstBytePlaneView& source,
                            const BytePlaneView& target, const Band& band) {
    return for_each_run(band, [&](Index y, Index from, Index to) {
      return row<Rule, sub>(fixed == nullptr ? nullptr : fixed + from, source.row(y) + from,
                            source.stride, target.row(y) + from, to - from) != 0;
    });
  }

 private:
  template <class Rule, int sub>
  static std::uint8_t row(const std::uint8_t* fixed, const std::uint8_t* source, Index stride,
                          std::uint8_t* __restrict target, Index count) {
    Bytes above = source - stride;
    Bytes here = source;
    Bytes below = source + stride;
    return write_pixels(
        fixed, here, target, count, [&](Index x) __attribute__((always_inline)) {
          return new_pixel<Rule, sub>(neighbourhood_at(above, here, below, x));
        });
  }

  template <TwoStageRule Rule, int sub>
  static std::uint8_t row(const std::uint8_t* fixed, const std::uint8_t* source, Index stride,
                          std::uint8_t* __restrict target, Index count) {
    std::uint8_t changed = 0;
    for (Index first = 0; first < count; first += FeatureStrip::kPixels) {
      const std::uint8_t* strip = source + first;
      FeatureStrip features;
      for (int i = 0; i < 3; ++i) features.fill<Rule>(i, strip + (i - 1) * stride, stride);
      Bytes above = strip - stride;
      Bytes here = strip;
      Bytes below = strip + stride;
      const std::uint8_t some = write_pixels(
          fixed == nullptr ? nullptr : fixed + first, here, target + first,
          FeatureStrip::kPixels, [&](Index x) __attribute__((always_inline)) {
            return new_pixel<Rule, sub>(neighbourhood_at(above, here, below, x),
                                        neighbourhood_at(features.rows[0] + 1, features.rows[1] + 1,
                                                         features.rows[2] + 1, x));
          });
      changed = static_cast<std::uint8_t>(changed | some);
    }
    return changed;
  }
};

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const AutovecPasses Exported<AutovecPasses, Isa::THINBENCH_ISA>::kKernels = {
    passes_by_rule<Autovec>()};

}  // namespace thinbench::detail
