// Tables as Markdown.
#pragma once

#include <string>
#include <vector>

namespace thinbench {

/// A Markdown table; all rows have as many cells as the head.
[[nodiscard]] std::string markdown_table(const std::vector<std::string>& head,
                                         const std::vector<std::vector<std::string>>& rows);

}  // namespace thinbench
