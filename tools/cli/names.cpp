#include "cli/names.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "support/usage.hpp"

namespace thinbench {
namespace {

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return lower;
}

/// Edits from a word to a name, first to the name's nearest beginning, then to all of it.
using Distance = std::pair<std::size_t, std::size_t>;

Distance distance(std::string_view word, std::string_view name) {
  std::vector<std::size_t> row(name.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < word.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < name.size(); ++j) {
      const std::size_t replaced = diagonal + (word[i] == name[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return {*std::min_element(row.begin(), row.end()), row.back()};
}

}  // namespace

std::optional<std::string_view> nearest_name(std::string_view word,
                                             const std::vector<std::string_view>& known) {
  const std::string typed = lower_case(word);
  std::optional<std::string_view> nearest;
  Distance least{typed.size() / 3 + 1, 0};  // beyond that it is another word
  for (const std::string_view name : known) {
    const Distance found = distance(typed, lower_case(name));
    if (typed.empty() || found >= least) continue;
    least = found;
    nearest = name;
  }
  return nearest;
}

void reject_name(std::string_view kind, std::string_view word,
                 const std::vector<std::string_view>& known) {
  std::string text = "no " + std::string(kind) + " is named '" + std::string(word) + "'; ";
  if (const auto nearest = nearest_name(word, known)) {
    throw UsageError(text + "did you mean '" + std::string(*nearest) + "'?");
  }
  throw UsageError(text + "known: " + enumeration(known));
}

std::string enumeration(const std::vector<std::string_view>& words, const char* before_last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? before_last : ", ";
    text += words[i];
  }
  return text;
}

Isa isa_named(std::string_view name) {
  return named("instruction set", name, all_isas(), isa_name);
}

Border border_named(std::string_view name) {
  return named("border", name, std::array{Border::background, Border::keep, Border::foreground},
               border_name);
}

Direction direction_named(std::string_view name) {
  const auto name_of = [](Direction one) { return kDirectionNames[static_cast<std::size_t>(one)]; };
  return named("direction", name, kAllDirections, name_of);
}

}  // namespace thinbench
