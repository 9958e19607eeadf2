#include "regress/table.hpp"

#include <cmath>
#include <map>

#include "support/text.hpp"

namespace thinbench {
namespace {

constexpr double kMoved = 0.03;
constexpr std::size_t kIndent = 14;

std::string moved(const char* side, double before, double now) {
  const double percent = 100 * (now / before - 1);
  if (std::abs(percent) < 100 * kMoved) return {};
  return std::string(side) + " " + fixed(std::abs(percent), 0) + " % " +
         (percent > 0 ? "slower" : "faster");
}

bool is_faster(const RegressionVerdict& row) {
  return row.verdict == Verdict::pass && row.change.low > 1 + row.tolerance;
}

std::string interval_text(const Change& change) {
  return fixed(change.ratio, 3) + " (" + fixed(change.low, 3) + " to " + fixed(change.high, 3) +
         ")";
}

std::string heading(const RegressionVerdict& row) {
  std::string verdict(name_of(row.verdict));
  verdict.resize(kIndent, ' ');
  return verdict + row.name + "\n" + std::string(kIndent, ' ');
}

std::string reason_of(const RegressionVerdict& row) {
  return row.reason.empty() ? "\n" : "; " + row.reason + "\n";
}

std::string us(double ns) {
  return fixed(ns / 1000, 1);
}

std::string change_text(const RegressionVerdict& row) {
  return heading(row) + "speed-up x " + interval_text(row.change) + ", limit " +
         fixed(1 - row.tolerance, 2) + "; row " + us(row.before.row_ns) + " -> " +
         us(row.now.row_ns) + " us, reference " + us(row.before.reference_ns) + " -> " +
         us(row.now.reference_ns) + " us: " + what_moved(row.before, row.now) + reason_of(row);
}

std::string simd_text(const RegressionVerdict& row) {
  return heading(row) + interval_text(row.change) + " times as fast as scalar code, limit " +
         fixed(1 - row.tolerance, 2) + "; " + us(row.now.row_ns) + " us, scalar " +
         us(row.before.row_ns) + " us" + reason_of(row);
}

/// One line for each reason.
std::string skipped_text(const std::vector<RegressionVerdict>& rows) {
  std::map<std::string, int> numbers;
  for (const RegressionVerdict& row : rows) {
    if (row.verdict == Verdict::skipped) ++numbers[row.reason];
  }
  std::string text;
  for (const auto& [reason, number] : numbers) {
    text += "SKIPPED       " + std::to_string(number) + " rows: " + reason + "\n";
  }
  return text;
}

}  // namespace

std::string what_moved(const PairTimes& before, const PairTimes& now) {
  std::vector<std::string> parts;
  for (const std::string& part : {moved("row", before.row_ns, now.row_ns),
                                  moved("reference", before.reference_ns, now.reference_ns)}) {
    if (!part.empty()) parts.push_back(part);
  }
  return parts.empty() ? "neither moved by 3 %" : joined(parts, ", ");
}

std::string to_table(const std::vector<RegressionVerdict>& rows, bool all) {
  std::string text;
  for (const RegressionVerdict& row : rows) {
    const bool shown = all || row.verdict != Verdict::pass || is_faster(row);
    if (shown && row.verdict != Verdict::skipped) text += change_text(row);
  }
  return text + skipped_text(rows);
}

std::string to_simd_table(const std::vector<RegressionVerdict>& rows, bool all) {
  std::string text;
  for (const RegressionVerdict& row : rows) {
    const bool shown = all || row.verdict != Verdict::pass;
    if (shown && row.verdict != Verdict::skipped) text += simd_text(row);
  }
  return text + skipped_text(rows);
}

std::string counts(const std::vector<RegressionVerdict>& rows) {
  std::map<Verdict, int> numbers;
  for (const RegressionVerdict& row : rows) ++numbers[row.verdict];
  std::vector<std::string> parts;
  parts.reserve(numbers.size());
  for (const auto& [verdict, number] : numbers) {
    parts.push_back(std::string(name_of(verdict)) + " " + std::to_string(number));
  }
  return parts.empty() ? "no rows" : joined(parts, ", ");
}

std::string to_line(const ControlVerdicts& controls) {
  return std::string(controls.pass ? "passed" : "FAILED") + ": a row against itself " +
         interval_text(controls.same) + ", slowed by 10 % on purpose " +
         interval_text(controls.slowed) +
         "; operations in doubt: " + std::to_string(controls.failed_groups.size());
}

}  // namespace thinbench
