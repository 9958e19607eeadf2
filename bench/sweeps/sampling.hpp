// Times: one sample of a point, and rounds of samples of all.
#pragma once

#include <functional>
#include <set>

#include "sweeps/journal.hpp"

namespace thinbench {

/// A sample lasts about as long (seconds), or a call where that takes longer.
inline constexpr double kSampleSeconds = 0.002;

/// What a visit of a point will take, memory made ready and warm-up included.
[[nodiscard]] double expected_seconds(const Point& point, const Proof& proof);

/// A round visits the inputs in random order, and the points of one input in random order, so that
/// no drift of the machine looks like a step of a sweep.
[[nodiscard]] std::vector<const Point*> order_of_round(const std::vector<const Point*>& points,
                                                       std::uint64_t seed);

/// Makes samples. Memory is made anew for each, as places in memory change times.
class Sampler {
 public:
  explicit Sampler(InputStore& inputs) : inputs_(inputs) {}

  /// Throws std::runtime_error where the first result of a point is not the one that was proved.
  [[nodiscard]] Sample take(const Point& point, const Proof& proof, int round);

 private:
  InputStore& inputs_;
  std::set<const Point*> checked_;
};

}  // namespace thinbench
