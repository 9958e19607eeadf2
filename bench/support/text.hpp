// Numbers as text, and tables as Markdown.
#pragma once

#include <string>
#include <vector>

namespace thinbench {

/// The shortest decimal that reads back as the same float: 7.18, not 7.17999983.
[[nodiscard]] std::string shortest(float value);

/// With a fixed number of decimals: fixed(4.8493, 2) is "4.85".
[[nodiscard]] std::string fixed(double value, int decimals);

/// The parts with the separator between them.
[[nodiscard]] std::string joined(const std::vector<std::string>& parts,
                                 const std::string& separator);

/// A Markdown table; all rows have as many cells as the head.
[[nodiscard]] std::string markdown_table(const std::vector<std::string>& head,
                                         const std::vector<std::vector<std::string>>& rows);

}  // namespace thinbench
