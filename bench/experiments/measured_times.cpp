#include "experiments/measured_times.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "thinbench/options.hpp"

namespace thinbench {
namespace {

using Cells = std::vector<std::string>;

/// Names with commas would be quoted, but only an image file can be called so, and none is read.
/// Nothing behind the last comma is an empty cell, too.
Cells cells_of(const std::string& line) {
  Cells cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  if (line.ends_with(',')) cells.emplace_back();
  return cells;
}

/// A table whose columns are found by name.
class Table {
 public:
  explicit Table(const std::string& path) : path_(path), file_(path) {
    std::string line;
    if (!std::getline(file_, line)) throw std::runtime_error("cannot read '" + path + "'");
    header_ = cells_of(line);
  }

  [[nodiscard]] std::size_t column(const std::string& name) const {
    const auto found = newer_column(name);
    if (!found) fail("has no column " + name);
    return *found;
  }

  /// Nothing where the file is older than the column.
  [[nodiscard]] std::optional<std::size_t> newer_column(const std::string& name) const {
    const auto found = std::find(header_.begin(), header_.end(), name);
    if (found == header_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - header_.begin());
  }

  /// False at the end.
  bool next(Cells& cells) {
    std::string line;
    if (!std::getline(file_, line)) return false;
    ++line_;
    cells = cells_of(line);
    if (cells.size() < header_.size()) fail("line " + std::to_string(line_) + " is truncated");
    return true;
  }

  [[nodiscard]] double number(const std::string& text) const {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec == std::errc() && result.ptr == end && value > 0) return value;
    fail("line " + std::to_string(line_) + ": '" + text + "' is no time");
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw std::runtime_error(path_ + ": " + problem);
  }

  std::string path_;
  std::ifstream file_;
  Cells header_;
  int line_ = 1;
};

void note(MeasuredTimes& times, const std::string& technique, const std::string& isa, double ns) {
  if (technique == "reference") {
    times.reference_ns = ns;
  } else if (!times.best_ns || ns < *times.best_ns) {
    times.best_ns = ns;
    times.best_variant = technique + " (" + isa + ")";
  }
}

}  // namespace

TimesByOperation read_measured_times(const std::string& folder) {
  Table table(folder + "/timings.csv");
  const std::size_t operation = table.column("operation");
  const std::size_t technique = table.column("technique");
  const std::size_t isa = table.column("isa");
  const std::size_t threads = table.column("threads");
  const std::size_t scope = table.column("scope");
  const std::size_t input = table.column("input");
  const std::size_t median = table.column("median_ns");
  const std::optional<std::size_t> border = table.newer_column("border");
  const std::optional<std::size_t> limit = table.newer_column("max_iterations");
  TimesByOperation times;
  for (Cells row; table.next(row);) {
    if ((border && row[*border] == border_name(Border::keep)) || (limit && !row[*limit].empty())) {
      continue;
    }
    if (row[threads] != "1" || row[scope] != "end_to_end" || row[input] != "scene") continue;
    note(times[row[operation]], row[technique], row[isa], table.number(row[median]));
  }
  return times;
}

}  // namespace thinbench
