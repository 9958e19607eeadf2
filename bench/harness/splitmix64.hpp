// The one generator of random numbers: the same bits on every machine, which the standard library's
// distributions do not promise.
#pragma once

#include <cstdint>

namespace thinbench {

/// Output number `index` of SplitMix64 (Steele, Lea, Flood 2014) started from `seed`. Output 0 is a
/// bijective mix of the seed's bits.
[[nodiscard]] constexpr std::uint64_t splitmix64(std::uint64_t seed, std::uint64_t index = 0) {
  std::uint64_t z = seed + 0x9E3779B97F4A7C15 * (index + 1);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

/// These numbers one after another.
class Random {
 public:
  explicit Random(std::uint64_t seed) : seed_(seed) {}

  std::uint64_t next() { return splitmix64(seed_, drawn_++); }

 private:
  std::uint64_t seed_;
  std::uint64_t drawn_ = 0;
};

}  // namespace thinbench
