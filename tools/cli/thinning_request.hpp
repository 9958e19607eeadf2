// Options of thinning operations: the commands that thin images take the same.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {

struct ThinningRequest {
  std::string operation;
  std::string weights;     // a file; empty: the default weights
  std::string directions;  // "rows,columns"; empty: all
  Options how;
};

/// --weights, --border, --directions and --max-iterations.
void add_thinning_options(CLI::App& app, ThinningRequest& request);

/// `request.how` with the net and the directions. Throws UsageError and std::runtime_error for what
/// does not apply to the rule or cannot be read.
[[nodiscard]] Options options_for(Rule rule, const ThinningRequest& request);

/// The options given that change results, each with a space before it: " --border keep".
[[nodiscard]] std::string thinning_words(const ThinningRequest& request);

}  // namespace thinbench
