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
}  // namespace thinbench

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  thinbench::must_succeed_or_explain<std::runtime_error>([&] {
    thinbench::read({data, data + size});
  });
  return 0;
}
