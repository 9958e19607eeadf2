// Single precision, one pixel per lane. For ISA files only.
#pragma once

#include "rules/exponential.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

inline constexpr Index kFloatLanes = static_cast<Index>(FloatBatch::size);

}  // namespace THINBENCH_ISA

// A specialisation belongs to the namespace of its template.

template <>
struct RealOps<FloatBatch> {
  [[gnu::always_inline]] static FloatBatch constant(float value) { return FloatBatch(value); }
  [[gnu::always_inline]] static FloatBatch clamped(FloatBatch x, float low, float high) {
    return simd::min(simd::max(x, FloatBatch(low)), FloatBatch(high));
  }
  [[gnu::always_inline]] static FloatBatch rounded(FloatBatch x) {
    const FloatBatch magic(12582912.0F);
    return (x + magic) - magic;
  }
  [[gnu::always_inline]] static FloatBatch power_of_two(FloatBatch n) {
    const IntBatch bits = (simd::to_int(n) + IntBatch(127)) << 23;
    return reinterpreted<FloatBatch>(bits);
  }
};

}  // namespace thinbench::detail
