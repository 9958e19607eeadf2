// What thins: a rule by any of its names, and the options of the commands that apply rules.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {

/// The words that users type.
struct ThinningRequest {
  std::string rule;
  std::string weights;     // a file; empty: the default weights
  std::string directions;  // "rows,columns"; empty: all
  bool optimise = false;
  Thinning thinning;
  Execution execution;
  std::vector<std::string_view> other_operations = {};  // what may be named as well, for messages
};

/// --weights, --border, --directions, --max-iterations and --optimise.
void add_thinning_options(CLI::App& app, ThinningRequest& request);

/// What they mean.
struct RequestedThinning {
  std::string name;      // of the operation, else of the rule
  std::string contents;  // of its file, as a hash: " hash 0123456789abcdef"; empty without one
  Rule rule;
  Thinning thinning;
  Execution execution;
};

/// A rule is a built-in rule or its operation, a named rule, Hensel's notation such as B3/S23, or a
/// JSON file. What could be several of these is a name; if not that, a notation, unless it ends
/// with .json. Throws UsageError and std::runtime_error for what does not apply to the rule or
/// cannot be read.
[[nodiscard]] RequestedThinning requested_thinning(const ThinningRequest& request);

/// Throws UsageError where the rule cannot be applied with these options.
void check_options(const RequestedThinning& requested);

}  // namespace thinbench
