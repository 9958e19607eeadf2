// e^x = 2^n e^r with n = round(x / ln 2) and |r| <= 0.35; ln 2 in two parts, the first with its low
// bits zero, so that n times it is exact. Then e^r by its Taylor series of degree 13: the next term
// is below 5e-18.
#include "training/portable_math.hpp"

#include <algorithm>
#include <bit>

namespace thinbench {

double portable_exp(double x) {
  constexpr double kLog2E = 1.4426950408889634;
  constexpr double kLn2High = 0x1.62e42feep-1;
  constexpr double kLn2Low = 0x1.a39ef35793c76p-33;
  constexpr int kDegree = 13;
  const double cut = std::clamp(x, -700.0, 700.0);
  const double scaled = cut * kLog2E;
  const auto n = static_cast<std::int64_t>(scaled + (scaled < 0 ? -0.5 : 0.5));
  const auto whole = static_cast<double>(n);
  const double r = (cut - whole * kLn2High) - whole * kLn2Low;
  double sum = 1;
  for (int i = kDegree; i > 0; --i) sum = 1 + sum * r / i;
  return sum * std::bit_cast<double>((n + 1023) << 52);
}

}  // namespace thinbench
