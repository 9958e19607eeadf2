// Whether one neuron can learn a run of consecutive descriptors, decided exactly.
#pragma once

#include <cstdint>
#include <vector>

#include "training/keep_table.hpp"

namespace thinbench {

/// The descriptors from `first` to `last`, both included.
struct DescriptorRun {
  int first;
  int last;
};

/// A vector, and how many times it is taken.
struct WeightedDescriptor {
  int descriptor;
  std::int64_t times;
};

/// Proof that no neuron answers correctly on a run: the kept vectors, each taken `times` times,
/// have the same sum and number as the removed ones. A neuron's net input, summed over the first,
/// would have to be at least 0 and, summed over the second, below 0: but the two sums are equal.
using Contradiction = std::vector<WeightedDescriptor>;

/// A contradiction within the run; empty if there is none, and then a neuron can learn the run
/// (Farkas). Exact: a simplex method in integers, at most 10 terms in the answer.
[[nodiscard]] Contradiction find_contradiction(const KeepTable& table, DescriptorRun run);

/// Checks a contradiction by adding up; shares nothing with the search.
[[nodiscard]] bool proves_inseparable(const Contradiction& contradiction, const KeepTable& table,
                                      DescriptorRun run);

}  // namespace thinbench
