// The variants of the thinning rules.
#pragma once

#include <vector>

#include "thinning/state.hpp"

namespace thinbench::detail {

/// Whether the rule decides every pixel of a sub-iteration from the image before it, so that all
/// engines compute it.
[[nodiscard]] bool is_parallel_rule(Rule rule);

/// All techniques for one parallel rule: what a new rule gets for free.
[[nodiscard]] std::vector<ThinningVariant> parallel_rule_variants(Rule rule);

/// The original, sequential SPTA.
[[nodiscard]] std::vector<ThinningVariant> spta_variants();

/// Makers that other families reuse.
[[nodiscard]] std::unique_ptr<ThinningState> make_bitpacked(const ThinningSetting& setting);
[[nodiscard]] std::unique_ptr<ThinningState> make_simd_bitpacked(const ThinningSetting& setting);
[[nodiscard]] std::unique_ptr<ThinningState> make_row(const ThinningSetting& setting);

/// Within an ISA, the technique with the highest number is the fastest where it can run.
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
