// Random numbers and an exponential that give the same bits on every machine: the standard library
// leaves the distributions open and the last bit of exp to the processor.
#pragma once

#include <cstdint>

#include "harness/splitmix64.hpp"

namespace thinbench {

class Random {
 public:
  explicit Random(std::uint64_t seed) : seed_(seed) {}

  std::uint64_t next() { return splitmix64(seed_, drawn_++); }

  /// Uniform in [-limit, limit), in steps of limit / 2^52.
  double symmetric(double limit) {
    constexpr double kUnit = 1.0 / (std::uint64_t{1} << 52);
    return (static_cast<double>(next() >> 11) * kUnit - 1.0) * limit;
  }

 private:
  std::uint64_t seed_;
  std::uint64_t drawn_ = 0;
};

/// e^x by + - * and a power of two put together from its bits; relative error about 1e-15.
/// Arguments are cut to [-700, 700], where the result is a normal number.
[[nodiscard]] double portable_exp(double x);

}  // namespace thinbench
