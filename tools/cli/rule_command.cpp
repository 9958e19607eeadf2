// thinbench rule: applies a custom rule to an image file.
#include <climits>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "cli/aligned.hpp"
#include "cli/arguments.hpp"
#include "cli/names.hpp"
#include "cli/thinbench.hpp"
#include "cli/thinning_run.hpp"
#include "rules/rule_file.hpp"
#include "support/whole_file.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

struct RuleOptions {
  std::string rule;
  ThinningFiles files;
  Options how;
  BinariseOptions binarise;
  std::optional<Border> border;  // instead of the rule's
  std::optional<int> max_iterations;
  bool optimise = false;
  std::string save;
  bool list = false;
};

void print_named_rules(std::ostream& out) {
  std::vector<Cells> lines = {
      {"name", "sub-iterations", "limit", "border", "what it does", "source"}};
  for (const NamedRule& rule : named_rules()) {
    const bool has_limit = rule.max_iterations != kUnlimited;
    lines.push_back({std::string(rule.name), std::to_string(rule.sub_iterations.size()),
                     has_limit ? std::to_string(rule.max_iterations) : "none",
                     std::string(border_name(rule.border)), std::string(rule.description),
                     std::string(rule.source)});
  }
  print_aligned(lines, out);
}

/// Whether it begins as Hensel's notation does.
bool is_notation(const std::string& word) {
  constexpr std::string_view sections = "bBsS";
  constexpr std::string_view after_letter = "/0123456789bBsS";
  return !word.empty() && sections.find(word[0]) != std::string_view::npos &&
         (word.size() == 1 || after_letter.find(word[1]) != std::string_view::npos);
}

bool is_file(const std::string& word) {
  std::error_code ignored;
  return word.find('/') != std::string::npos || word.ends_with(".json") ||
         std::filesystem::exists(word, ignored);
}

RuleDescription rule_of_notation(const std::string& word) {
  try {
    return {word.substr(0, kMaxRuleNameLength), {table_from_hensel(word)}};
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

RuleDescription rule_of_name(const std::string& word) {
  const auto name_of = [](const NamedRule& rule) { return rule.name; };
  const NamedRule rule = named("rule", word, named_rules(), name_of);
  return {word,
          {rule.sub_iterations.begin(), rule.sub_iterations.end()},
          rule.border,
          rule.max_iterations};
}

/// What could be several things is a name; if not that, a notation, unless it ends with .json.
RuleDescription rule_of_word(const std::string& word) {
  if (find_named_rule(word) != nullptr) return rule_of_name(word);
  if (is_notation(word) && !word.ends_with(".json")) return rule_of_notation(word);
  return is_file(word) ? read_rule_file(word) : rule_of_name(word);
}

RuleDescription requested_rule(const RuleOptions& options) {
  RuleDescription rule = rule_of_word(options.rule);
  rule.border = options.border.value_or(rule.border);
  rule.max_iterations = options.max_iterations.value_or(rule.max_iterations);
  return rule;
}

CustomRule compiled(const RuleDescription& rule, const RuleOptions& options) {
  CustomRuleOptions all = rule.options();
  all.optimise = options.optimise;
  try {
    return CustomRule(rule.sub_iterations, all);
  } catch (const std::invalid_argument& error) {  // it has no limit and needs one
    throw UsageError(options.rule + ": " + error.what() + ", such as --max-iterations 100");
  }
}

/// "10 + 10".
std::string gates_of(const CustomRule& rule) {
  std::vector<int> gates;
  for (std::size_t i = 0; i < rule.sub_iterations().size(); ++i) gates.push_back(rule.gates(i));
  return fmt::format("{}", fmt::join(gates, " + "));
}

std::string apply_to_files(const RuleOptions& options, const Thinning& thinning,
                           const Console& console) {
  const ThinningFiles& files = options.files;
  if (!files.out.ends_with(".pbm")) {
    return thin_image_file(thinning, files, options.binarise, options.how, console);
  }
  reject_for_packed_files(options.binarise);
  check_target(files.out);
  return thin_packed_file(thinning, files, pbm_format(files.in), options.how);
}

void save(const RuleOptions& options, const RuleDescription& rule, std::ostream& out) {
  write_rule_file(options.save, rule);
  const std::size_t count = rule.sub_iterations.size();
  out << fmt::format("{}: {}, {} sub-iteration{}\n", options.save, rule.name, count,
                     count == 1 ? "" : "s");
}

void check_words(const RuleOptions& options) {
  const bool has_in = !options.files.in.empty();
  if (options.list && !options.rule.empty()) throw UsageError("--list takes no RULE");
  if (!options.list && options.rule.empty()) throw UsageError("rule needs RULE, or --list");
  if (has_in && options.files.out.empty()) throw UsageError("rule needs OUT, an image to write");
  if (!options.list && !has_in && options.save.empty()) {
    throw UsageError("rule needs IN and OUT, or --save");
  }
}

int run(const RuleOptions& options, const Console& console) {
  check_words(options);
  if (options.list) {
    print_named_rules(console.out);
    return kSuccess;
  }
  const RuleDescription description = requested_rule(options);
  const CustomRule rule = compiled(description, options);
  if (!options.save.empty()) save(options, description, console.out);
  if (options.files.in.empty()) return kSuccess;
  const std::string gates = gates_of(rule);  // compiles the rule before its time is taken
  console.out << apply_to_files(options, {description.name, rule}, console) << ", gates: " << gates
              << '\n';
  return kSuccess;
}

void add_rule_options(CLI::App& app, RuleOptions& options) {
  const auto set_border = [&options](const std::string& name) {
    const std::array borders = {Border::background, Border::keep, Border::foreground};
    options.border = named("border", name, borders, border_name);
  };
  app.add_option_function<std::string>(
         "--border", set_border,
         "What lies outside the image: background, foreground, or keep: background, and the "
         "outermost rows and columns never change (default: the rule's own)")
      ->check(not_empty())
      ->type_name("NAME");
  app.add_option("--max-iterations", options.max_iterations,
                 "Stop after N iterations (default: the rule's own limit)")
      ->check(whole_number(1, INT_MAX))
      ->type_name("N");
  app.add_flag("--optimise", options.optimise,
               "Search longer for fewer gates: up to 2 s per table instead of 20 ms");
  app.add_option("--save", options.save, "Write the rule as a JSON file; needs no IN and OUT")
      ->check(not_empty())
      ->type_name("FILE");
  app.add_flag("--list", options.list, "Print the named rules");
}

}  // namespace

Command add_rule_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("rule", "Apply a rule of your own to an image file");
  const auto options = std::make_shared<RuleOptions>();
  app->add_option("RULE", options->rule,
                  "JSON file, name of a rule, or Hensel's notation such as B3/S23")
      ->type_name("");
  app->add_option("IN", options->files.in, "Image to read")->type_name("");
  app->add_option("OUT", options->files.out,
                  "Image to write: .png, .pgm, .bmp, .tif or, from PBM (P4), .pbm")
      ->type_name("");
  add_rule_options(*app, *options);
  add_isa_option(*app, options->how.isa);
  add_threads_option(*app, options->how.threads);
  add_binarise_options(*app, options->binarise);
  app->footer(R"(Examples:
  thinbench rule --list
  thinbench rule majority parts.jpg smooth.png --foreground dark
  thinbench rule prune skeleton.png pruned.png --max-iterations 5
  thinbench rule B3/S23 parts.png life.png --max-iterations 100
  thinbench rule my_rule.json parts.png out.png --border foreground --optimise
  thinbench rule golay_l --save golay_l.json

A rule gives the new value of a pixel for each of the 512 values of its 3 x 3 window; docs/rules.md
describes rules and their files. OUT holds 255 on foreground and 0 elsewhere. The summary ends with the
three-input gates of each sub-iteration.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
