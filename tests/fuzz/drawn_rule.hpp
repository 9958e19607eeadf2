// Rules of any kind, and what their references make of an image.
#pragma once

#include "byte_source.hpp"
#include "compile/rule_body.hpp"
#include "reference.hpp"
#include "thinbench/named_rules.hpp"

namespace thinbench {

/// Built in, named, or the midpoint scan along some directions. Now and then one that does not
/// exist, for which this throws std::invalid_argument.
inline Rule draw_rule(ByteSource& input) {
  const Index kind = input.number(0, 15);
  if (kind < 4) return Rule::named(input.pick(named_rules()).name);
  if (kind == 4) return Rule(Directions{static_cast<std::uint8_t>(input.number(0, 16))});
  const auto last = static_cast<Index>(kRules.size()) - 1;
  return static_cast<BuiltInRule>(input.number(0, input.once_in(32) ? last + 1 : last));
}

/// By the reference of the rule's name; otherwise, and where foreground is outside, by its tables.
inline int apply_reference(const Rule& rule, const Thinning& thinning, const ConstImageView& source,
                           const ImageView& destination) {
  const reference::Repetition repetition = {
      thinning.border.value_or(rule.border()),
      thinning.max_iterations.value_or(rule.max_iterations())};
  const auto built_in = rule_from_name(rule.name());
  if (!built_in || repetition.border == Border::foreground) {
    return reference::apply_tables(rule.sub_iterations(), repetition, source, destination);
  }
  if (*built_in == BuiltInRule::midpoint_scan) {
    return reference::midpoint_scan(rule.body()->directions, repetition.border, source,
                                    destination);
  }
  return reference::thinning(*built_in)(repetition, source, destination);
}

}  // namespace thinbench
