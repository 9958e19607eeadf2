#include "cli/tables.hpp"

#include <cmath>
#include <fstream>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/file_bytes.hpp"
#include "support/json_field.hpp"
#include "support/text.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::ordered_json;

std::string cell_of(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return csv_cell(value.get_ref<const std::string&>());
  if (!value.is_number_float()) return value.dump();
  const auto number = value.get<double>();
  return std::isfinite(number) ? fmt::to_string(number) : "";
}

/// Of these values, where an array stands for its elements.
std::string row_of(const std::vector<Json>& values) {
  std::string row;
  const auto add = [&row](const Json& value) { row += (row.empty() ? "" : ",") + cell_of(value); };
  for (const Json& value : values) {
    if (!value.is_array()) add(value);
    for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) add(value[i]);
  }
  return row + '\n';
}

/// What all rows of an image begin with.
Json image_of(const Json& found) {
  return {found.at("file"), found.at("page"), found.at("width"), found.at("height")};
}

std::string region_row(const Json& image, const char* kind, const Json& region,
                       const Json& enclosing_object) {
  return row_of({image, kind, region.at("id"), enclosing_object, region.at("area"),
                 region.at("centre"), region.at("box")});
}

std::string region_rows(const Json& found) {
  const Json image = image_of(found);
  std::string rows;
  for (const Json& object : found.at("objects")) {
    rows += region_row(image, "object", object, 0);
    for (const Json& hole : object.at("holes")) {
      rows += region_row(image, "hole", hole, object.at("id"));
    }
  }
  return rows;
}

std::string edge_rows(const Json& found) {
  const Json image = image_of(found);
  const auto kind_of = [&nodes = found.at("nodes")](const Json& id) {
    return nodes.at(id.get<std::size_t>() - 1).at("kind");
  };
  std::string rows;
  for (const Json& edge : found.at("edges")) {
    const Json &from = edge.at("from"), &to = edge.at("to"), &points = edge.at("points");
    rows += row_of({image, edge.at("id"), from, to, kind_of(from), kind_of(to), points.at(0),
                    points.at(points.size() - 1), edge.at("pixels"), edge.at("length"),
                    edge.at("smoothed_length"), edge.at("chord"), edge.at("width_mean"),
                    edge.at("width_median"), edge.at("width_min"), edge.at("width_max"),
                    found.at("unit"), edge.value("label", Json())});
  }
  return rows;
}

std::string csv_head(bool is_graph) {
  return std::string("file,page,image_width,image_height,") +
         (is_graph ? "id,from,to,from_kind,to_kind,start_x,start_y,stop_x,stop_y,pixels,length,"
                     "smoothed_length,chord,"
                     "width_mean,width_median,width_min,width_max,unit,label\n"
                   : "kind,id,enclosing_object,area,centre_x,centre_y,left,top,width,height\n");
}

std::string csv_rows(const Json& found) {
  return found.contains("nodes") ? edge_rows(found) : region_rows(found);
}

std::string text_of(const TablePart& part, TableFormat format) {
  const FileBytes file = read_file(part.path);
  try {
    Json found = Json::parse(file.text());
    found.at("file") = part.image;  // whose name may be no UTF-8
    return format == TableFormat::csv ? csv_rows(found) : json_line(found);
  } catch (const Json::exception&) {
    cannot_read(part.path, "it is not what this batch writes; delete it and use --resume");
  }
}

}  // namespace

std::string csv_text(const Json& found) {
  return csv_head(found.contains("nodes")) + csv_rows(found);
}

void write_table(const std::string& path, bool is_graph,
                 const std::function<std::optional<TablePart>()>& next) {
  const TableFormat format = table_format("--table", path);
  write_whole_file(path, [&](const std::string& name) {
    std::ofstream file(name, std::ios::binary);
    if (format == TableFormat::csv) file << csv_head(is_graph);
    while (const auto part = next()) {
      if (!(file << text_of(*part, format))) break;
    }
    if (!file.flush()) cannot_write_by_errno(path);
  });
}

}  // namespace thinbench
