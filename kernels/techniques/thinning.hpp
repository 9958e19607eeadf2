// The techniques that thinning is compared with.
#pragma once

#include "engines/state.hpp"

namespace thinbench::detail {

/// Those that suit the rule.
[[nodiscard]] ThinningVariants thinning_techniques(const RuleBody& rule);

}  // namespace thinbench::detail
