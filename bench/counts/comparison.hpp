// Counts against those of an earlier build: the exact part of the regression check.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace thinbench {

/// Counts below this part of a change are the same: memory may lie a little differently.
inline constexpr double kCountTolerance = 0.01;

struct MovedRow {
  std::string row;
  std::uint64_t before;
  std::uint64_t now;  // 0 where the row takes more steps than are counted

  [[nodiscard]] bool is_more() const { return now == 0 || now > before; }
};

/// A row that takes another number of iterations, which no speed of a kernel explains.
struct ChangedIterations {
  std::string row;
  std::int64_t before;
  std::int64_t now;
};

struct Comparison {
  std::string why_not;  // the files cannot be compared; empty where they can
  std::size_t compared = 0;
  std::size_t otherwise_counted = 0;  // by another method than before: not compared
  std::vector<MovedRow> moved;        // by more than the tolerance

  std::vector<ChangedIterations> iterations;  // of rows that were compared

  [[nodiscard]] std::size_t more() const;
  [[nodiscard]] bool fails() const { return more() > 0 || !iterations.empty(); }
};

/// The document of counts in a file. Throws std::runtime_error with one line that names the file
/// where there is none, or one of another schema.
[[nodiscard]] nlohmann::json read_counts(const std::string& file);

/// Rows that both documents have. They are comparable where build and input are the same, and a row
/// where it was counted by the same method, callgrind's by the same valgrind.
[[nodiscard]] Comparison compare(const nlohmann::json& before, const nlohmann::json& now);

/// What moved, a line each, and a line that sums up.
[[nodiscard]] std::string to_text(const Comparison& comparison);

}  // namespace thinbench
