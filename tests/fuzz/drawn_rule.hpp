// Rules of any kind.
#pragma once

#include "byte_source.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {

/// Built in or named. Now and then one that does not exist, for which this throws
/// std::invalid_argument.
inline Rule draw_rule(ByteSource& input) {
  const Index kind = input.number(0, 15);
  if (kind < 4) return Rule::named(input.pick(named_rules()).name);
  const auto last = static_cast<Index>(kRules.size()) - 1;
  return static_cast<BuiltInRule>(input.number(0, input.once_in(32) ? last + 1 : last));
}

}  // namespace thinbench
