#include "support/text.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/usage.hpp"

namespace thinbench {

std::string markdown_table(const std::vector<std::string>& head,
                           const std::vector<std::vector<std::string>>& rows) {
  const auto row = [](const auto& cells) {
    return fmt::format("| {} |\n", fmt::join(cells, " | "));
  };
  std::string table = row(head) + row(std::vector<std::string>(head.size(), "---"));
  for (const std::vector<std::string>& cells : rows) table += row(cells);
  return table;
}

std::string one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    line += code < 0x20 || code == 0x7F ? fmt::format("\\x{:02x}", code) : std::string(1, c);
  }
  return line;
}

bool is_printable(const std::string& text) {
  try {
    static_cast<void>(nlohmann::json(text).dump());
  } catch (const nlohmann::json::exception&) {
    return false;
  }
  return one_line(text) == text;
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

TableFormat table_format(const std::string& option, const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".csv") return TableFormat::csv;
  if (extension == ".jsonl") return TableFormat::json_lines;
  throw UsageError(option + ": expected a name that ends in .csv or .jsonl, got '" + path + "'");
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace thinbench
