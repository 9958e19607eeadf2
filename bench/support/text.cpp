#include "support/text.hpp"

#include <array>
#include <charconv>

namespace thinbench {
namespace {

std::string markdown_row(const std::vector<std::string>& cells) {
  return std::string("| ") + joined(cells, " | ") + " |\n";
}

}  // namespace

std::string shortest(float value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string fixed(double value, int decimals) {
  std::array<char, 400> text{};  // the largest double has 309 digits before the point
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, decimals);
  return {text.data(), end.ptr};
}

std::string joined(const std::vector<std::string>& parts, const std::string& separator) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i != 0) text += separator;
    text += parts[i];
  }
  return text;
}

std::string markdown_table(const std::vector<std::string>& head,
                           const std::vector<std::vector<std::string>>& rows) {
  const std::vector<std::string> rule(head.size(), "---");
  std::string table = markdown_row(head) + markdown_row(rule);
  for (const std::vector<std::string>& row : rows) table += markdown_row(row);
  return table;
}

}  // namespace thinbench
