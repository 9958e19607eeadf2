#include "cli/thinning_request.hpp"

#include <climits>
#include <filesystem>
#include <variant>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/names.hpp"
#include "rules/rule_file.hpp"
#include "rules/weights_file.hpp"
#include "support/content_hash.hpp"
#include "support/file_bytes.hpp"
#include "support/json_field.hpp"
#include "support/usage.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/rule_notation.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

struct NamedValue {
  std::string name;
  Rule rule;
  std::string contents = {};  // as in RequestedThinning
};

std::string contents_of(const FileBytes& file) {
  return " hash " + hash_text(hash_of(file.text().data(), file.text().size()));
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

NamedValue rule_of_notation(const std::string& word, bool optimise) {
  const auto make = [&] {
    return Rule(table_from_hensel(word), {.optimise = optimise, .name = word});
  };
  return {word.substr(0, kMaxRuleNameLength), checked_usage(make)};
}

NamedValue rule_of_file(const std::string& path, bool optimise) {
  const FileBytes file = read_file(path, kMaxJsonBytes);
  const RuleDescription read = parse_rule(std::string(file.text()), path);
  return {read.name,
          Rule(read.sub_iterations, {read.border, read.max_iterations, optimise, read.name}),
          contents_of(file)};
}

/// Of a word that names nothing.
[[noreturn]] void reject_rule(const std::string& word, std::vector<std::string_view> known) {
  for (const std::string_view moved : {"spta", "thin_spta", "net_two_layer_rounded"}) {
    if (word != moved) continue;
    throw UsageError(word +
                     " is a part of the study: 'thinbench_benchmarks --pictures DIRECTORY "
                     "--image IMAGE' writes what it makes of an image");
  }
  const char* const kind = known.empty() ? "rule" : "operation";
  for (const RuleInfo& info : kRules) known.push_back(info.operation);
  for (const NamedRule& rule : named_rules()) known.push_back(rule.name);
  reject_name(kind, word, known);
}

NamedValue rule_of_name(const ThinningRequest& request) {
  const std::string& word = request.rule;
  const bool optimise = request.optimise;
  if (const auto built_in = rule_from_name(word)) {
    if (optimise) throw UsageError("--optimise: " + word + " is built in, not given by tables");
    return {std::string(rule_info(*built_in).operation), *built_in};
  }
  const NamedRule* const found = find_named_rule(word);
  if (found == nullptr) reject_rule(word, request.other_operations);
  return {word,
          Rule(found->sub_iterations, {found->border, found->max_iterations, optimise, word})};
}

NamedValue rule_of_word(const ThinningRequest& request) {
  const std::string& word = request.rule;
  const bool is_name = rule_from_name(word).has_value() || find_named_rule(word) != nullptr;
  if (!is_name && is_notation(word) && !word.ends_with(".json")) {
    return rule_of_notation(word, request.optimise);
  }
  if (!is_name && is_file(word)) return rule_of_file(word, request.optimise);
  return rule_of_name(request);
}

/// The net with the weights in a file.
Rule net_from_file(const NamedValue& rule, const FileBytes& file) {
  const std::string& path = file.name();
  if (!rule.name.starts_with("net_")) {
    throw UsageError("--weights: " + rule.name + " is not a net and has no weights");
  }
  const AnyWeights weights = parse_weights(std::string(file.text()), path);
  const bool wants_cluster = rule.name == "net_single_layer_cluster";
  if (wants_cluster != std::holds_alternative<ClusterWeights>(weights)) {
    const std::string wanted = wants_cluster ? "cluster" : "two_layer";
    throw std::runtime_error(path + ": holds the wrong kind of weights; " + rule.name + " needs " +
                             wanted);
  }
  if (wants_cluster) return Rule::from_net(std::get<ClusterWeights>(weights));
  const bool is_linear = rule.name == "net_two_layer_linear";
  return Rule::from_net(std::get<TwoLayerWeights>(weights),
                        is_linear ? Activation::linear : Activation::sigmoid);
}

}  // namespace

void add_thinning_options(CLI::App& app, ThinningRequest& request) {
  add_file_option(app, "--weights", request.weights,
                  "Weights of a net, made by 'thinbench-study train'");
  add_value(
      app, "--border",
      [&request](const std::string& name) { request.thinning.border = border_named(name); },
      "What is outside the image: background, foreground, or keep: background, and the "
      "outermost rows and columns never change, as in OpenCV (default: the rule's own)",
      not_empty(), "NAME");
  add_value(app, "--directions", request.directions,
            "Where midpoint_scan looks: rows, columns, diagonals, antidiagonals (default: all)",
            not_empty(), "NAME,...");
  add_value(app, "--max-iterations", request.thinning.max_iterations,
            "Stop after N iterations (default: the rule's own limit, if it has one, else when "
            "nothing changes any more)",
            whole_number(1, INT_MAX), "N");
  app.add_flag("--optimise", request.optimise,
               "Search longer for fewer gates of a rule given by tables: up to 2 s per table "
               "instead of 20 ms");
}

RequestedThinning requested_thinning(const ThinningRequest& request) {
  NamedValue rule = rule_of_word(request);
  if (!request.weights.empty()) {
    const FileBytes file = read_file(request.weights, kMaxJsonBytes);
    rule.rule = net_from_file(rule, file);
    rule.contents = contents_of(file);
  }
  if (!request.directions.empty()) {
    throw UsageError("--directions: " + rule.name + " is not a scan and has no directions");
  }
  return {rule.name, rule.contents, rule.rule, request.thinning, request.execution};
}

void check_options(const RequestedThinning& requested) {
  checked_usage([&] { const Thinner on_one_pixel(requested.rule, 1, 1, requested.thinning); });
}

}  // namespace thinbench
