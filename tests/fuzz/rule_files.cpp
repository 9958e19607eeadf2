// Files of rules: a rule, or one line that says what is wrong.
#include <stdexcept>

#include "byte_source.hpp"
#include "rules/rule_file.hpp"

namespace thinbench {
namespace {

void read(const std::string& text) {
  const RuleDescription rule = parse_rule(text, "input.json");
  must(!rule.name.empty() && rule.name.size() <= kMaxRuleNameLength, "a name of a wrong length");
  const Rule made(rule.sub_iterations, {rule.border, rule.max_iterations});
  must(made.sub_iterations().size() == rule.sub_iterations.size(), "tables were lost");
}

}  // namespace

void try_input(ByteSource& input) {
  must_succeed_or_explain<std::runtime_error>([&] { read(input.rest()); });
}

}  // namespace thinbench
