// Thinning rules: what one pixel becomes, given its neighbourhood. Each rule stands once, in a file
// of its own, as an expression over any word type, and every engine instantiates it.
#pragma once

#include "thinning/rules/guo_hall.hpp"
#include "thinning/rules/mb2.hpp"
#include "thinning/rules/naccache_shinghal.hpp"
#include "thinning/rules/spta_directional.hpp"
#include "thinning/rules/zhang_suen.hpp"

namespace thinbench::detail {

template <class... Rules>
struct RuleList {};

/// Every rule that engines instantiate. A new rule is a file beside these and a name here.
using AllRules = RuleList<NaccacheShinghal, ZhangSuen, GuoHall, SptaDirectional, Mb2>;

}  // namespace thinbench::detail
