#include "experiments/report.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/json_field.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::ordered_json;

/// "/sums/logical" as "sums logical".
std::string head_of(std::string path) {
  path.erase(0, 1);
  std::replace_if(
      path.begin(), path.end(), [](char c) { return c == '/' || c == '_'; }, ' ');
  return path;
}

std::string cell_of(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_float()) return fmt::format("{:.4g}", value.get<double>());
  if (value.is_string()) return value.get<std::string>();
  return value.is_null() ? "" : value.dump();
}

std::string table_of(const Json& objects) {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows(objects.size());
  const Json paths = objects.at(0).flatten();
  for (const auto& [path, unused] : paths.items()) {
    const Json::json_pointer pointer(path);
    const auto is_empty = [&](const Json& row) { return cell_of(row.at(pointer)).empty(); };
    if (std::all_of(objects.begin(), objects.end(), is_empty)) continue;
    head.push_back(head_of(path));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].push_back(cell_of(objects[i].at(pointer)));
    }
  }
  return markdown_table(head, rows);
}

/// An object is a table of one row.
Json rows_in(const Json& value) {
  if (value.is_object()) return Json::array({value});
  return value.is_array() && !value.empty() && value[0].is_object() ? value : Json();
}

}  // namespace

ExperimentReport report_of(const std::string& name, const std::string& caption, const Json& data,
                           const std::string& options) {
  Json json = {{"schema", 1},
               {"experiment", name},
               {"command", "thinbench-study experiment " + name + options}};
  json.update(data);
  std::string markdown = caption + "\n";
  for (const auto& [key, value] : data.items()) {
    const Json rows = rows_in(value);
    if (!rows.is_null()) markdown.append("\n").append(table_of(rows));
  }
  return {json_text(json), markdown};
}

}  // namespace thinbench
