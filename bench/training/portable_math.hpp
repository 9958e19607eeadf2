// Random numbers and an exponential that give the same bits on every machine: the standard library
// leaves the distributions open and the last bit of exp to the processor.
#pragma once

#include <cstdint>

namespace thinbench {

/// SplitMix64 (Steele, Lea, Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
  }

  /// Uniform in [-limit, limit), in steps of limit / 2^52.
  double symmetric(double limit) {
    constexpr double kUnit = 1.0 / (std::uint64_t{1} << 52);
    return (static_cast<double>(next() >> 11) * kUnit - 1.0) * limit;
  }

 private:
  std::uint64_t state_;
};

/// e^x by + - * and a power of two put together from its bits; relative error about 1e-15.
/// Arguments are cut to [-700, 700], where the result is a normal number.
[[nodiscard]] double portable_exp(double x);

}  // namespace thinbench
