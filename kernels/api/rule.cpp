#include "thinbench/rule.hpp"

#include <array>
#include <mutex>
#include <utility>

#include "compile/rule_body.hpp"
#include "core/checks.hpp"
#include "rules/nets.hpp"
#include "rules/notation_reader.hpp"
#include "rules/rule_table.hpp"
#include "rules/trained_cluster.hpp"
#include "thinbench/named_rules.hpp"

namespace thinbench {

using detail::RuleBody;
using detail::RuleKind;
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

/// A net runs by its table; the one that the paper trained its nets on has circuits.
void set_net(RuleBody& body, const WindowTable& table, const detail::NetWeights& weights) {
  static const auto& kPaperRule = *new auto(tables_of<detail::NaccacheShinghal>());
  body.reach = 1;
  body.net = weights;
  if (table == kPaperRule.front()) body.circuits = BuiltInRule::naccache_shinghal;
  set_tables(body, std::span(&table, 1), false);
}

void set_net(RuleBody& body, const TwoLayerWeights& weights, Activation activation) {
  set_net(body, detail::table_of(weights, activation), detail::TwoLayerNet{weights, activation});
}

void set_net(RuleBody& body, const ClusterWeights& weights) {
  set_net(body, detail::table_of(weights), weights);
}

/// The default weights of the rules that are nets.
void set_default_net(RuleBody& body, BuiltInRule rule) {
  using enum BuiltInRule;
  if (rule == net_two_layer_sigmoid) set_net(body, kPaperTwoLayer, Activation::sigmoid);
  if (rule == net_two_layer_rounded) set_net(body, kRoundedTwoLayer, Activation::sigmoid);
  if (rule == net_two_layer_linear) set_net(body, kPaperTwoLayer, Activation::linear);
  if (rule == net_single_layer_cluster) set_net(body, detail::kTrainedCluster);
}

SharedRule make_built_in(const RuleInfo& info) {
  auto body = std::make_shared<RuleBody>();
  body->name = info.name;
  body->operation = info.operation;
  body->reach = info.reach;
  if (info.rule == BuiltInRule::spta) body->kind = RuleKind::spta;
  if (info.rule == BuiltInRule::midpoint_scan) body->kind = RuleKind::midpoints;
  detail::for_each_parallel_rule([&]<class Type>(BuiltInRule rule) {
    if (rule != info.rule) return;
    body->circuits = rule;
    const auto tables = tables_of<Type>();
    if (!tables.empty()) set_tables(*body, tables, false);
  });
  set_default_net(*body, info.rule);
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
  body->operation = options.name;
  body->reach = static_cast<int>(tables.size());
  body->border = options.border;
  body->max_iterations = options.max_iterations;
  set_tables(*body, tables, options.optimise);
  return body;
}

template <class... Weights>
SharedRule make_net(const Weights&... weights) {
  auto body = std::make_shared<RuleBody>();
  body->name = "net";
  body->operation = body->name;
  set_net(*body, weights...);
  return body;
}

SharedRule make_midpoint_scan(Directions directions) {
  detail::require(directions.bits >> kDirectionCount == 0,
                  "directions: expected bits in [0, 15], got " + std::to_string(directions.bits));
  auto body = std::make_shared<RuleBody>(*built_in_body(BuiltInRule::midpoint_scan));
  body->directions = directions;
  return body;
}

}  // namespace

Rule::Rule(BuiltInRule rule) : body_(built_in_body(rule)) {}

Rule::Rule(std::span<const WindowTable> sub_iterations, const RuleOptions& options)
    : body_(make_from_tables(sub_iterations, options)) {}

Rule::Rule(const TwoLayerWeights& weights, Activation activation)
    : body_(make_net(weights, activation)) {}

Rule::Rule(const ClusterWeights& weights) : body_(make_net(weights)) {}

Rule::Rule(Directions directions) : body_(make_midpoint_scan(directions)) {}

Rule Rule::named(std::string_view name) {
  if (const auto rule = rule_from_name(name)) return *rule;
  const NamedRule* const found = find_named_rule(name);
  detail::require(found != nullptr, "rule: expected a name, got " + detail::quoted(name));
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
  return body_->reach;
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
