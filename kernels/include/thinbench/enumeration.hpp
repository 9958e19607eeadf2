// Values of enumerations, and lists with an entry for each.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

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

}  // namespace thinbench::detail
