// Lists with an entry for every value of an enumeration.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace thinbench::detail {

/// The entry of a value. Throws std::invalid_argument for a value outside the enumeration.
template <class Entries, class Value>
[[nodiscard]] constexpr const auto& entry_of(const Entries& entries, Value value,
                                             const char* name) {
  const auto number = static_cast<std::size_t>(value);
  if (number < entries.size()) return entries[number];
  throw std::invalid_argument(std::string(name) + ": expected one of the enumeration, got number " +
                              std::to_string(number));
}

}  // namespace thinbench::detail
