#include "regress/table.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "support/text.hpp"

namespace thinbench {
namespace {

constexpr double kMoved = 0.03;

std::string moved(const char* side, double before, double now) {
  const double percent = 100 * (now / before - 1);
  if (std::abs(percent) < 100 * kMoved) return {};
  return std::string(side) + " " + fixed(std::abs(percent), 0) + " % " +
         (percent > 0 ? "slower" : "faster");
}

bool is_faster(const RowVerdict& row) {
  return row.verdict == Verdict::kPass && row.change.low > 1 + row.tolerance;
}

std::string interval_text(const Change& change) {
  return fixed(change.ratio, 3) + " (" + fixed(change.low, 3) + " to " + fixed(change.high, 3) +
         ")";
}

std::string lines_of(const RowVerdict& row) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(),
                "%-12s  %s\n              speed-up changed by %s, limit %.2f; row %.1f -> %.1f us, "
                "reference %.0f -> %.0f us: %s%s%s\n",
                std::string(name_of(row.verdict)).c_str(), row.name.c_str(),
                interval_text(row.change).c_str(), 1 - row.tolerance, row.before.row_ns / 1000,
                row.now.row_ns / 1000, row.before.reference_ns / 1000, row.now.reference_ns / 1000,
                what_moved(row.before, row.now).c_str(), row.reason.empty() ? "" : "; ",
                row.reason.c_str());
  return text.data();
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

std::string to_table(const std::vector<RowVerdict>& rows, bool all) {
  std::string text;
  std::map<std::string, int> skipped;
  for (const RowVerdict& row : rows) {
    if (row.verdict == Verdict::kSkipped) {
      ++skipped[row.reason];
    } else if (all || row.verdict != Verdict::kPass || is_faster(row)) {
      text += lines_of(row);
    }
  }
  for (const auto& [reason, number] : skipped) {
    text += "SKIPPED       " + std::to_string(number) + " rows: " + reason + "\n";
  }
  return text;
}

std::string counts(const std::vector<RowVerdict>& rows) {
  std::map<Verdict, int> numbers;
  for (const RowVerdict& row : rows) ++numbers[row.verdict];
  std::vector<std::string> parts;
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
