// The techniques that thinning is compared with.
#pragma once

#include "engines/state.hpp"

namespace thinbench::detail {

/// Those that suit the rule.
[[nodiscard]] ThinningVariants thinning_techniques(const RuleBody& rule);

/// Sequential SPTA; the setting's rule does not matter.
[[nodiscard]] std::unique_ptr<ThinningState> make_spta(const ThinningSetting& setting);

}  // namespace thinbench::detail
