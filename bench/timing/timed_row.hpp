// What is timed: one variant (or a reference) in one scope on one input.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/rows.hpp"
#include "timing/inputs.hpp"

namespace thinbench {

enum class Scope {
  kernel,      // the variant's own representation in and out
  end_to_end,  // bytes in, bytes out
};

[[nodiscard]] constexpr std::string_view scope_name(Scope scope) {
  return scope == Scope::kernel ? "kernel" : "end_to_end";
}

/// Which ISAs of a technique are timed.
enum class Levels { all, highest };

struct TimedRow {
  std::string name;  // case/technique/isa/threads/scope/input
  const Operation* operation;
  const Variant* variant;  // nullptr for the reference
  int threads;
  Scope scope;
  const TimedInput* input;
  std::optional<std::int64_t> counter;  // see Operation::counter
  /// Memory that the row's job holds, its planes included; calls ask for no more.
  std::optional<std::int64_t> plan_bytes = std::nullopt;

  [[nodiscard]] const JobMaker& maker() const {
    return variant != nullptr ? variant->make_job : operation->reference;
  }
};

struct SkippedRow {
  std::string name;
  std::string reason;
};

/// Rows that may be timed, because they were compared with the reference first, and all others.
struct Selection {
  std::vector<TimedRow> rows;
  std::vector<SkippedRow> skipped;
  std::vector<std::string> mismatches;
  int verified = 0;  // variants equal to the reference, counted once an input
};

/// Compares every row whose name matches `filter` with the reference on every input. References
/// come along with any row of their case and input. Cases that are not timed as a rule take part
/// where the filter spells their name out, see is_requested(). Series of sizes get one row per
/// technique: the highest available ISA, end to end. Rows point to `operations` and `inputs`.
[[nodiscard]] Selection select_rows(const std::string& filter,
                                    const std::vector<Operation>& operations,
                                    const std::vector<TimedInput>& inputs,
                                    Levels levels = Levels::all);

/// Rows whose call takes longer, in seconds, are timed with fewer repetitions and not warmed up.
inline constexpr double kSlowCall = 0.005;

/// Calls the row and returns the seconds it took; for choosing iteration counts.
[[nodiscard]] double seconds_of_one_call(const TimedRow& row);

}  // namespace thinbench
