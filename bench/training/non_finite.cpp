#include "training/non_finite.hpp"

#include <array>
#include <string_view>

namespace thinbench {
namespace {

constexpr std::array<std::string_view, 3> kNames = {"NaN", "Infinity", "-Infinity"};
constexpr char kMark = '\x7F';  // a text that begins with it was written by nobody

/// What stands between the quotation marks.
std::string mark_of(std::string_view name) {
  std::string text(name.substr(0, name.size() - 2));
  text.front() = kMark;
  return text;
}

/// The end of the text that begins at `at`, behind its last quotation mark.
std::size_t end_of_text(const std::string& json, std::size_t at) {
  for (++at; at < json.size() && json[at] != '"'; ++at) {
    if (json[at] == '\\') ++at;
  }
  return at + 1;
}

}  // namespace

std::string with_non_finite_marked(std::string json) {
  for (std::size_t at = 0; at < json.size();) {
    if (json[at] == '"') {
      at = end_of_text(json, at);
      continue;
    }
    for (const std::string_view name : kNames) {
      if (json.compare(at, name.size(), name) != 0) continue;
      json.replace(at, name.size(), '"' + mark_of(name) + '"');
      at += name.size() - 1;
      break;
    }
    ++at;
  }
  return json;
}

std::optional<std::string> non_finite_name(const std::string& text) {
  for (const std::string_view name : kNames) {
    if (text == mark_of(name)) return std::string(name);
  }
  return std::nullopt;
}

}  // namespace thinbench
