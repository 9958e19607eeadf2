// thinbench rule: lists rules, describes one, and writes it as a file.
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "cli/aligned.hpp"
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/thinbench.hpp"
#include "cli/thinning_request.hpp"
#include "rules/rule_file.hpp"
#include "support/text.hpp"
#include "thinbench/named_rules.hpp"

namespace thinbench {
namespace {

struct RuleCommandOptions {
  ThinningRequest request;
  std::string save;
  bool list = false;
};

std::string limit_text(int max_iterations) {
  return max_iterations == kUnlimited ? "none" : std::to_string(max_iterations);
}

void print_named_rules(std::ostream& out) {
  std::vector<Cells> lines = {
      {"name", "sub-iterations", "limit", "border", "what it does", "source"}};
  for (const NamedRule& rule : named_rules()) {
    lines.push_back({std::string(rule.name), std::to_string(rule.sub_iterations.size()),
                     limit_text(rule.max_iterations), std::string(border_name(rule.border)),
                     std::string(rule.description), std::string(rule.source)});
  }
  print_aligned(lines, out);
}

/// "10 + 10".
std::string gates_of(const Rule& rule) {
  std::vector<int> gates;
  for (std::size_t i = 0; i < rule.sub_iterations().size(); ++i) gates.push_back(rule.gates(i));
  return fmt::format("{}", fmt::join(gates, " + "));
}

RuleDescription description_of(const RequestedThinning& requested) {
  const auto tables = requested.rule.sub_iterations();
  if (tables.empty()) {
    throw UsageError(requested.name + " does not depend on 3 x 3 pixels alone and has no tables");
  }
  return {requested.name,
          {tables.begin(), tables.end()},
          requested.thinning.border.value_or(requested.rule.border()),
          requested.thinning.max_iterations.value_or(requested.rule.max_iterations())};
}

int run(const RuleCommandOptions& options, const Console& console) {
  if (options.list && !options.request.rule.empty()) throw UsageError("--list takes no RULE");
  if (!options.list && options.request.rule.empty()) throw UsageError("rule needs RULE, or --list");
  if (options.list) {
    print_named_rules(console.out);
    return kSuccess;
  }
  const RequestedThinning requested = requested_thinning(options.request);
  const RuleDescription rule = description_of(requested);
  if (!options.save.empty()) write_rule_file(options.save, rule);
  console.out << fmt::format("{}: {}, gates {}, border {}, limit {}\n", rule.name,
                             counted(rule.sub_iterations.size(), "sub-iteration"),
                             gates_of(requested.rule), border_name(rule.border),
                             limit_text(rule.max_iterations));
  return kSuccess;
}

}  // namespace

Command add_rule_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("rule", "List rules, describe one, or write it as a file");
  const auto options = std::make_shared<RuleCommandOptions>();
  app->add_option("RULE", options->request.rule, "Any rule that 'thinbench run' takes")
      ->type_name("");
  add_thinning_options(*app, options->request);
  add_file_option(*app, "--save", options->save, "Write the rule as a JSON file", file_name());
  app->add_flag("--list", options->list, "Print the named rules");
  app->footer(R"(Examples:
  thinbench rule --list
  thinbench rule golay_l
  thinbench rule B3/S23 --optimise
  thinbench rule golay_l --save golay_l.json

A rule gives the new value of a pixel for each of the 512 values of its 3 x 3 window; docs/rules.md
describes rules and their files. Gates are those of three inputs of each sub-iteration.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
