#include "batch/manifest_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/json_field.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::ordered_json;
using Cells = std::vector<std::string>;

template <class Value>
Json json_or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

double to_microseconds(double seconds) {
  return std::round(seconds * 1e6) / 1e6;
}

Json json_of(const BatchRecord& record) {
  const bool was_read = record.width > 0;
  return {{"file", record.file},
          {"page", record.page},
          {"output", record.output},
          {"operation", record.operation},
          {"width", was_read ? Json(record.width) : Json()},
          {"height", was_read ? Json(record.height) : Json()},
          {"foreground", json_or_null(record.foreground)},
          {"threshold", record.threshold ? json_number(*record.threshold) : Json()},
          {"iterations", json_or_null(record.iterations)},
          {"foreground_before", json_or_null(record.foreground_before)},
          {"foreground_after", json_or_null(record.foreground_after)},
          {"objects", json_or_null(record.objects)},
          {"holes", json_or_null(record.holes)},
          {"decode_seconds", to_microseconds(record.decode_seconds)},
          {"compute_seconds", to_microseconds(record.compute_seconds)},
          {"encode_seconds", to_microseconds(record.encode_seconds)},
          {"warning", text_or_null(record.warning)},
          {"error", text_or_null(record.error)}};
}

std::string cell_of(const Json& value) {
  if (value.is_null()) return {};
  return value.is_string() ? csv_cell(value.get_ref<const std::string&>()) : value.dump();
}

/// Reads records one after another.
class CsvReader {
 public:
  explicit CsvReader(std::string_view text) : text_(text) {}

  /// Nothing where no complete record is left.
  std::optional<Cells> next() {
    Cells cells(1);
    bool is_quoted = false;
    for (std::size_t i = end_; i < text_.size(); ++i) {
      const char c = text_[i];
      const bool is_doubled = is_quoted && text_.substr(i, 2) == "\"\"";
      if (is_doubled) cells.back() += text_[i++];
      if (c == '"' && !is_doubled) is_quoted = !is_quoted;
      if (c == '"') continue;
      if (c == '\n' && !is_quoted) {
        end_ = i + 1;
        return cells;
      }
      if (c == ',' && !is_quoted) {
        cells.emplace_back();
      } else {
        cells.back() += c;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::size_t end() const { return end_; }

 private:
  std::string_view text_;
  std::size_t end_ = 0;  // of the last record that was read
};

Cells column_names() {
  const Json json = json_of({});
  Cells names;
  for (const auto& [name, value] : json.items()) names.push_back(name);
  return names;
}

[[noreturn]] void fail(const std::string& why) {
  throw std::runtime_error("it is not a manifest of this program: " + why);
}

std::size_t column(const Cells& names, std::string_view name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

int page_of(const std::string& cell) {
  int page = 0;
  const char* const end = cell.data() + cell.size();
  const auto result = std::from_chars(cell.data(), end, page);
  if (result.ec != std::errc() || result.ptr != end) fail("a page has no number");
  return page;
}

ManifestText parse_csv(std::string_view text) {
  const Cells names = column_names();
  CsvReader reader(text);
  ManifestText result;
  const auto head = reader.next();
  if (!head && manifest_head(TableFormat::csv).starts_with(text)) return result;
  if (head != names) fail("its first line does not name the columns");
  for (std::size_t start = reader.end(); const auto cells = reader.next(); start = reader.end()) {
    if (cells->size() != names.size()) fail("a line has the wrong number of columns");
    const auto at = [&](std::string_view name) { return (*cells)[column(names, name)]; };
    result.lines.push_back({std::string(text.substr(start, reader.end() - start)), at("file"),
                            at("output"), page_of(at("page")), at("operation"),
                            !at("error").empty()});
  }
  result.size = reader.end();
  return result;
}

/// A line of JSON with its newline.
ManifestLine line_of_json(const std::string& line) {
  try {
    const nlohmann::json json = parse_json(line, "a line");
    const nlohmann::json page = json.value("page", nlohmann::json(1));
    return {line,
            json.value("file", ""),
            json.value("output", ""),
            static_cast<int>(page.get_ref<const Json::number_integer_t&>()),
            json.value("operation", ""),
            !json.at("error").is_null()};
  } catch (const nlohmann::json::exception&) {  // falls through, as the next
  } catch (const std::runtime_error&) {
  }
  fail("a line is not a record");
}

ManifestText parse_json_lines(std::string_view text) {
  constexpr std::string_view kStart = R"({"file":)";
  ManifestText result;
  if (!text.starts_with(kStart.substr(0, text.size()))) fail("its first line is not a record");
  std::size_t end = 0;
  while ((end = text.find('\n', result.size)) != std::string_view::npos) {
    result.lines.push_back(
        line_of_json(std::string(text.substr(result.size, end + 1 - result.size))));
    result.size = end + 1;
  }
  return result;
}

}  // namespace

void check_name(const std::string& name, TableFormat format) {
  try {
    if (format == TableFormat::json_lines) static_cast<void>(Json(name).dump());
  } catch (const Json::exception&) {
    throw std::runtime_error("a manifest in JSON cannot hold the name '" + name +
                             "', which is not UTF-8; use one in CSV");
  }
}

std::string manifest_head(TableFormat format) {
  return format == TableFormat::csv ? fmt::format("{}\n", fmt::join(column_names(), ",")) : "";
}

std::string manifest_line(const BatchRecord& record, TableFormat format) {
  const Json json = json_of(record);
  if (format == TableFormat::json_lines) return json_line(json);
  Cells cells;
  for (const Json& value : json) cells.push_back(cell_of(value));
  return fmt::format("{}\n", fmt::join(cells, ","));
}

ManifestText parse_manifest(std::string_view text, TableFormat format) {
  return format == TableFormat::csv ? parse_csv(text) : parse_json_lines(text);
}

}  // namespace thinbench
