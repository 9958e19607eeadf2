// The variants of the thinning rules.
#pragma once

#include <vector>

#include "thinning/state.hpp"

namespace thinbench::detail {

/// Whether the rule is in rules.hpp.
[[nodiscard]] bool is_parallel_rule(Rule rule);

/// All techniques of a parallel rule.
[[nodiscard]] std::vector<ThinningVariant> parallel_rule_variants(Rule rule);

/// The original, sequential SPTA.
[[nodiscard]] std::vector<ThinningVariant> spta_variants();

/// For nets, too.
[[nodiscard]] std::unique_ptr<ThinningState> make_bitpacked(const ThinningSetting& setting);
[[nodiscard]] std::unique_ptr<ThinningState> make_simd_bitpacked(const ThinningSetting& setting);
[[nodiscard]] std::unique_ptr<ThinningState> make_row(const ThinningSetting& setting);

/// Within an ISA, from the slowest technique to the fastest.
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
