// Texts for people: tables as Markdown, one line of what may hold more; extensions of file names.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

namespace thinbench {

/// A Markdown table; all rows have as many cells as the head.
[[nodiscard]] std::string markdown_table(const std::vector<std::string>& head,
                                         const std::vector<std::vector<std::string>>& rows);

/// "1 pixel", "3 pixels"; the plural where it is another than that with an s.
template <std::integral Integer>
[[nodiscard]] std::string counted(Integer count, const std::string& what,
                                  const std::string& plural = {}) {
  const std::string& many = plural.empty() ? what + 's' : plural;
  return std::to_string(count) + ' ' + (count == 1 ? what : many);
}

/// With \x0a and so on for newlines and other control characters, as names of files may hold.
[[nodiscard]] std::string one_line(const std::string& text);

/// Whether it is UTF-8 without control characters.
[[nodiscard]] bool is_printable(const std::string& text);

/// The extension of a file with its dot, in lower case: ".tif" of "PAGE.TIF"; empty if there is
/// none.
[[nodiscard]] std::string extension_of(const std::string& path);

/// .csv, or .jsonl with a JSON object on each line.
enum class TableFormat : std::uint8_t { csv, json_lines };

/// By the extension. Throws UsageError for others, which begins with the name of the option.
[[nodiscard]] TableFormat table_format(const std::string& option, const std::string& path);

/// In quotation marks where CSV needs them (RFC 4180).
[[nodiscard]] std::string csv_cell(const std::string& text);

}  // namespace thinbench
