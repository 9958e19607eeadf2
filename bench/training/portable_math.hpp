// Random numbers and an exponential that give the same bits on every machine: the standard library
// leaves the distributions open and the last bit of exp to the processor.
#pragma once

#include <cstdint>

#include "harness/splitmix64.hpp"

namespace thinbench {

/// Uniform in [-1, 1), in steps of 2^-52.
inline double symmetric(Random& random) {
  constexpr double kUnit = 1.0 / (std::uint64_t{1} << 52);
  return static_cast<double>(random.next() >> 11) * kUnit - 1.0;
}

/// e^x by + - * and a power of two put together from its bits; relative error about 1e-15.
/// Arguments are cut to [-700, 700], where the result is a normal number.
[[nodiscard]] double portable_exp(double x);

}  // namespace thinbench
