// What every experiment leaves: a JSON file and a Markdown table.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace thinbench {

struct ExperimentReport {
  std::string json;      // whole file: schema, experiment, command, then the data
  std::string markdown;  // tables, each with a sentence that says what it shows
};

/// Puts schema, name and command before the data; `options` are the command's, such as " --quick".
[[nodiscard]] std::string experiment_json(const std::string& name,
                                          const nlohmann::ordered_json& data,
                                          const std::string& options = "");

}  // namespace thinbench
