// What the commands find, as JSON and as tables with a row for each region or edge.
#pragma once

#include <cstdint>
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

/// One line, or indented. Ends with a newline.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& found);
[[nodiscard]] std::string json_line(const nlohmann::ordered_json& found);

/// The names of the columns: of objects and holes, or of the edges of graphs.
[[nodiscard]] std::string csv_head(bool is_graph);

/// Of regions_json() or graph_json(): an object before its holes; each edge. Infinite numbers are
/// empty. Throws nlohmann::json::exception for other JSON.
[[nodiscard]] std::string csv_rows(const nlohmann::ordered_json& found);

/// The head and the rows.
[[nodiscard]] std::string csv_text(const nlohmann::ordered_json& found);

/// Of all images of a batch: .csv, or .jsonl with the JSON of an image on each line.
enum class TableFormat : std::uint8_t { csv, json_lines };

/// By the extension. Throws UsageError for others.
[[nodiscard]] TableFormat table_format(const std::string& path);

/// A file of found JSON, and the image that it is about.
struct TablePart {
  std::string path;
  std::string image;
};

/// Writes the parts, one after another, until there is none. The table appears as a whole or not at
/// all. Throws FileError.
void write_table(const std::string& path, bool is_graph,
                 const std::function<std::optional<TablePart>()>& next);

}  // namespace thinbench
