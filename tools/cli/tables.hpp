// What the commands find as tables with a row for each region or edge.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace thinbench {

/// What a result is about.
struct ImagePage {
  std::string file;
  int page = 1;  // from 1
};

/// Of regions_json() or graph_json(), below the names of the columns: an object before its holes;
/// each edge. Infinite numbers are empty. Throws nlohmann::json::exception for other JSON.
[[nodiscard]] std::string csv_text(const nlohmann::ordered_json& found);

/// A file of found JSON, and the image that it is about.
struct TablePart {
  std::string path;
  std::string image;
};

/// Writes the parts, one after another, until there is none: of CSV the rows, of JSON lines an
/// image on each. The table appears as a whole or not at all. Throws FileError.
void write_table(const std::string& path, bool is_graph,
                 const std::function<std::optional<TablePart>()>& next);

}  // namespace thinbench
