#include "thinbench/rule.hpp"

#include <array>
#include <mutex>
#include <utility>

#include "compile/rule_body.hpp"
#include "core/checks.hpp"
#include "rules/nets.hpp"
#include "rules/notation_reader.hpp"
#include "rules/rule_table.hpp"
#include "thinbench/named_rules.hpp"

namespace thinbench {

using detail::RuleBody;
using detail::SharedRule;

namespace {

/// Foreground and background exchanged: what is foreground outside becomes background.
std::vector<WindowTable> complemented(std::span<const WindowTable> tables) {
  std::vector<WindowTable> result;
  for (const WindowTable& table : tables) {
    result.push_back(make_window_table(
        [&](std::size_t window) { return !table[WindowTable::kWindows - 1 - window]; }));
  }
  return result;
}

/// Gives a rule its tables, and their complement.
void set_tables(RuleBody& body, std::span<const WindowTable> tables, bool optimise) {
  const auto effort = optimise ? detail::kThoroughSearch : detail::kFastSearch;
  body.compiled = detail::compile(tables, effort);
  auto complement = std::make_shared<RuleBody>(body);
  complement->circuits = std::nullopt;
  complement->compiled = detail::compile(complemented(tables), effort);
  body.complement = std::move(complement);
}

/// The tables of a built-in rule; none for other types.
template <class Type>
std::vector<WindowTable> tables_of() {
  std::vector<WindowTable> tables;
  if constexpr (!detail::TwoStageRule<Type>) {
    [&]<int... subs>(std::integer_sequence<int, subs...>) {
      (tables.push_back(detail::make_window_table_of<Type, subs>()), ...);
    }
    (std::make_integer_sequence<int, Type::kSubIterations>{});
  }
  return tables;
}

SharedRule make_built_in(const RuleInfo& info) {
  auto body = std::make_shared<RuleBody>();
  body->name = info.name;
  detail::for_each_parallel_rule([&]<class Type>(BuiltInRule rule) {
    if (rule != info.rule) return;
    body->circuits = rule;
    const auto tables = tables_of<Type>();
    if (!tables.empty()) set_tables(*body, tables, false);
  });
  return body;
}

/// Made when first used, and never destroyed, as threads may still run when the program ends.
const SharedRule& built_in_body(BuiltInRule rule) {
  struct Entry {
    std::once_flag once;
    SharedRule body;
  };
  static auto& entries = *new std::array<Entry, kRules.size()>;
  const RuleInfo& info = rule_info(rule);
  Entry& entry = entries[static_cast<std::size_t>(rule)];
  std::call_once(entry.once, [&] { entry.body = make_built_in(info); });
  return entry.body;
}

SharedRule make_from_tables(std::span<const WindowTable> tables, const RuleOptions& options) {
  using detail::require;
  require(!tables.empty() && tables.size() <= Rule::kMaxSubIterations,
          "a rule has 1 to " + std::to_string(Rule::kMaxSubIterations) + " sub-iterations, not " +
              std::to_string(tables.size()));
  require(static_cast<std::size_t>(options.border) < kBorderNames.size(),
          "border: expected background, keep or foreground, got " +
              std::to_string(static_cast<int>(options.border)));
  require(options.max_iterations >= 1, "max_iterations: expected an integer of at least 1, got " +
                                           std::to_string(options.max_iterations));
  auto body = std::make_shared<RuleBody>();
  body->name = options.name;
  body->border = options.border;
  body->max_iterations = options.max_iterations;
  set_tables(*body, tables, options.optimise);
  return body;
}

/// A net that decides as the rule on which the paper trained its nets has that rule's circuits.
SharedRule make_net(const WindowTable& table, std::string_view name) {
  const SharedRule& learned = built_in_body(BuiltInRule::naccache_shinghal);
  if (table != learned->compiled->tables().front()) {
    return make_from_tables(std::span(&table, 1), {.name = std::string(name)});
  }
  auto body = std::make_shared<RuleBody>(*learned);
  body->name = name;
  return body;
}

}  // namespace

Rule::Rule(BuiltInRule rule) : body_(built_in_body(rule)) {}

Rule::Rule(std::span<const WindowTable> sub_iterations, const RuleOptions& options)
    : body_(make_from_tables(sub_iterations, options)) {}

Rule Rule::from_net(const TwoLayerWeights& weights, Activation activation) {
  return Rule(make_net(detail::table_of(weights, activation), "net"));
}

Rule Rule::from_net(const ClusterWeights& weights) {
  return Rule(make_net(detail::table_of(weights), "net"));
}

Rule Rule::named(std::string_view name) {
  if (const auto rule = rule_from_name(name)) return *rule;
  const NamedRule* const found = find_named_rule(name);
  detail::require(found != nullptr, "rule: expected a name, got " + detail::quoted(name));
  if (name.starts_with("net_")) return Rule(make_net(found->sub_iterations.front(), found->name));
  return Rule(found->sub_iterations, {.border = found->border,
                                      .max_iterations = found->max_iterations,
                                      .name = std::string(found->name)});
}

std::string_view Rule::name() const {
  return body_->name;
}

Border Rule::border() const {
  return body_->border;
}

int Rule::max_iterations() const {
  return body_->max_iterations;
}

int Rule::reach() const {
  constexpr int reach_of_5x5 = 2;
  return body_->compiled ? static_cast<int>(sub_iterations().size()) : reach_of_5x5;
}

std::span<const WindowTable> Rule::sub_iterations() const {
  if (!body_->compiled) return {};
  return body_->compiled->tables();
}

int Rule::gates(std::size_t sub_iteration) const {
  const std::size_t count = sub_iterations().size();
  detail::require(sub_iteration < count, "sub-iteration " + std::to_string(sub_iteration) +
                                             " of a rule with " + std::to_string(count));
  return detail::cost_of(body_->compiled->circuit(sub_iteration), detail::ternary_costs());
}

}  // namespace thinbench
