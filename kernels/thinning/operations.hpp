// The operations of thinning, and states for any rule.
#pragma once

#include <span>
#include <vector>

#include "engines/state.hpp"

namespace thinbench::detail {

/// One per built-in rule, in the order of the catalogue. They live as long as the program.
[[nodiscard]] std::span<const ThinningOperation> thinning_operations();

/// The variants of any rule, which live as long as the program.
[[nodiscard]] const std::vector<ThinningVariant>& thinning_variants(const RuleBody& rule);

/// Throws std::invalid_argument for options that are out of range or that the rule cannot have.
[[nodiscard]] ThinningParameters thinning_parameters(const Rule& rule, const Thinning& thinning);

/// What a caller asks for.
struct ThinningCall {
  Rule rule;
  Thinning thinning = {};
  Execution execution = {};

  /// The same on one thread.
  [[nodiscard]] ThinningCall on_one_thread() const {
    return {rule, thinning, {.threads = 1, .isa = execution.isa}};
  }
};

/// The state for images of this size. Throws std::invalid_argument as thin() does.
[[nodiscard]] std::unique_ptr<ThinningState> make_thinning(const ThinningCall& call, Index width,
                                                           Index height);

}  // namespace thinbench::detail
