// What every experiment gives: a JSON file, and the same as Markdown tables.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace thinbench {

struct ExperimentReport {
  std::string json;      // whole file: schema, experiment, command, then the data
  std::string markdown;  // the caption, and a table for each object or list of objects
};

/// `options` are the command's, such as " --quick". Objects within the rows of a table become
/// columns; columns without any value are omitted.
[[nodiscard]] ExperimentReport report_of(const std::string& name, const std::string& caption,
                                         const nlohmann::ordered_json& data,
                                         const std::string& options = "");

}  // namespace thinbench
