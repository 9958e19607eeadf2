// Tables on the terminal.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace thinbench {

using Cells = std::vector<std::string>;

/// A line each, all with as many cells, in columns as wide as their widest cell.
void print_aligned(const std::vector<Cells>& lines, std::ostream& out);

}  // namespace thinbench
