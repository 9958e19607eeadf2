// e^x in single precision for scalars and batches, bit-identical on every ISA.
#pragma once

namespace thinbench::detail {

/// Operations beyond + - *; techniques/float_nets.hpp specialises this for batches.
template <class Real>
struct RealOps;

template <>
struct RealOps<float> {
  static constexpr float constant(float value) { return value; }
  static constexpr float clamped(float x, float low, float high) {
    return x < low ? low : (x > high ? high : x);
  }
  /// The nearest integer for |x| < 2^22, ties to even: adding 1.5 * 2^23 leaves no fraction bits.
  static constexpr float rounded(float x) {
    constexpr float magic = 12582912.0F;
    return (x + magic) - magic;
  }
  /// 2^n for integers n in [-126, 127].
  static constexpr float power_of_two(float n) {
    return __builtin_bit_cast(float, (static_cast<int>(n) + 127) << 23);
  }
};

/// e^x for x clamped to [-87, 87]: x = n ln 2 + r with |r| <= ln 2 / 2, then the Taylor polynomial
/// of degree 7 in r by Horner's rule, times 2^n. n ln 2 is subtracted in two parts; the first has
/// few bits, so its product is exact. Relative error below 1.1e-7:
/// docs/experiments.md#nets.
template <class Real>
[[gnu::always_inline]] constexpr Real exponential(Real x) {
  using Ops = RealOps<Real>;
  const auto c = [](float value) { return Ops::constant(value); };
  const Real clamped = Ops::clamped(x, -87.0F, 87.0F);
  const Real n = Ops::rounded(clamped * c(1.44269504F));
  const Real r = (clamped - n * c(0.693359375F)) + n * c(2.12194440e-4F);
  Real sum = c(1.0F / 5040);
  sum = sum * r + c(1.0F / 720);
  sum = sum * r + c(1.0F / 120);
  sum = sum * r + c(1.0F / 24);
  sum = sum * r + c(1.0F / 6);
  sum = sum * r + c(0.5F);
  sum = sum * r + c(1.0F);
  sum = sum * r + c(1.0F);
  return sum * Ops::power_of_two(n);
}

/// Equation (1).
template <class Real>
[[gnu::always_inline]] constexpr Real sigmoid(Real x) {
  const Real one = RealOps<Real>::constant(1.0F);
  return one / (one + exponential(RealOps<Real>::constant(0.0F) - x));
}

}  // namespace thinbench::detail
