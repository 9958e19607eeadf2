// The variants of the thinning rules.
#pragma once

#include <vector>

#include "thinning/state.hpp"

namespace thinbench::detail {

/// Whether the rule is in rules.hpp.
[[nodiscard]] bool is_parallel_rule(Rule rule);

/// The variants of a parallel rule.
[[nodiscard]] std::vector<ThinningVariant> parallel_rule_variants(Rule rule);

/// The variants of the original, sequential SPTA.
[[nodiscard]] std::vector<ThinningVariant> spta_variants();

/// Factories that nets share.
[[nodiscard]] std::unique_ptr<ThinningState> make_bitpacked(const ThinningSetting& setting);
[[nodiscard]] std::unique_ptr<ThinningState> make_simd_bitpacked(const ThinningSetting& setting);
[[nodiscard]] std::unique_ptr<ThinningState> make_row(const ThinningSetting& setting);

/// Priorities within an ISA: the highest is the fastest technique.
enum ThinningPriority : int {
  kLutPriority,
  kLutSlidingPriority,
  kAutovecPriority,
  kFloatBitsPriority,
  kFixedPointPriority,
  kBitpackedPriority,
  kBytesPriority,
  kSimdBitpackedPriority,
  kTilesPriority,
  kRowPriority,
};

}  // namespace thinbench::detail
