// NaN, Infinity and -Infinity in JSON: the format has none, but Python writes them.
#pragma once

#include <optional>
#include <string>

namespace thinbench {

/// Puts a marked text of the same length in the place of each such value, so that the file can be
/// parsed and whoever reads the value can name its field.
[[nodiscard]] std::string with_non_finite_marked(std::string json);

/// "NaN", "Infinity" or "-Infinity" where the text is such a mark.
[[nodiscard]] std::optional<std::string> non_finite_name(const std::string& text);

}  // namespace thinbench
