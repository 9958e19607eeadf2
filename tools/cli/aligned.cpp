#include "cli/aligned.hpp"

#include <algorithm>
#include <iomanip>

namespace thinbench {

void print_aligned(const std::vector<Cells>& lines, std::ostream& out) {
  std::vector<std::size_t> widths(lines.front().size());
  for (const Cells& cells : lines) {
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], cells[i].size());
  }
  for (const Cells& cells : lines) {
    for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
      out << std::left << std::setw(static_cast<int>(widths[i]) + 2) << cells[i];
    }
    out << cells.back() << '\n';
  }
}

}  // namespace thinbench
