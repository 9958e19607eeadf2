// Names that users type: found, or rejected with the nearest known one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "thinbench/isa.hpp"
#include "thinbench/midpoint_scan.hpp"
#include "thinbench/options.hpp"

namespace thinbench {

/// The known name that `word` is probably a slip of: few edits away from it or from its beginning.
[[nodiscard]] std::optional<std::string_view> nearest_name(
    std::string_view word, const std::vector<std::string_view>& known);

/// Throws UsageError: "no <kind> is named '<word>'; did you mean ...", or the list of all.
[[noreturn]] void reject_name(std::string_view kind, std::string_view word,
                              const std::vector<std::string_view>& known);

/// "a, b and c".
[[nodiscard]] std::string enumeration(const std::vector<std::string_view>& words,
                                      const char* before_last = " and ");

/// The value of this name. Throws UsageError where none has it.
template <class Values, class NameOf>
[[nodiscard]] auto named(std::string_view kind, std::string_view name, const Values& values,
                         const NameOf& name_of) {
  std::vector<std::string_view> known;
  for (const auto& value : values) {
    if (name_of(value) == name) return value;
    known.push_back(name_of(value));
  }
  reject_name(kind, name, known);
}

/// Each throws UsageError for an unknown name.
[[nodiscard]] Isa isa_named(std::string_view name);
[[nodiscard]] Border border_named(std::string_view name);
[[nodiscard]] Direction direction_named(std::string_view name);

}  // namespace thinbench
