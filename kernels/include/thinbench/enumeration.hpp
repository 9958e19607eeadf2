// Values of enumerations, and lists with an entry for each.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace thinbench::detail {

/// Throws std::invalid_argument for a value outside the enumeration, which counts from 0.
template <class Value>
constexpr void require_enumerator(Value value, std::size_t count, const char* name) {
  const auto number = static_cast<std::size_t>(value);
  if (number < count) return;
  throw std::invalid_argument(std::string(name) + ": expected one of the enumeration, got number " +
                              std::to_string(number));
}

/// The entry of a value. Throws as require_enumerator().
template <class Entries, class Value>
[[nodiscard]] constexpr const auto& entry_of(const Entries& entries, Value value,
                                             const char* name) {
  require_enumerator(value, entries.size(), name);
  return entries[static_cast<std::size_t>(value)];
}

/// The value whose entry is this name; names are in the order of the enumeration.
template <class Value, class Names>
[[nodiscard]] constexpr std::optional<Value> value_named(const Names& names,
                                                         std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<Value>(i);
  }
  return std::nullopt;
}

}  // namespace thinbench::detail
