// What is measured: one variant, or a reference, in one scope on one input.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/operation.hpp"
#include "measure/inputs.hpp"

namespace thinbench {

enum class Scope {
  kernel,      // the variant's own representation in and out
  end_to_end,  // bytes in, bytes out
};

[[nodiscard]] constexpr std::string_view scope_name(Scope scope) {
  return scope == Scope::kernel ? "kernel" : "end_to_end";
}

struct TimedRow {
  std::string name;  // case/technique/isa/threads/scope/input
  const Operation* operation;
  const Variant* variant;  // nullptr for the reference
  int threads;
  Scope scope;
  const TimedInput* input;
  std::optional<std::int64_t> iterations = std::nullopt;

  [[nodiscard]] const JobMaker& maker() const {
    return variant != nullptr ? variant->make_job : operation->reference;
  }
  [[nodiscard]] ConstImageView view() const { return input->view(*operation); }
  [[nodiscard]] bool is_peer() const { return variant != nullptr && variant->is_peer; }
};

/// Which variants of an operation are measured. Peers always are, unless none are wanted. In the
/// order of kVariantChoices in row_options.cpp.
enum class VariantChoice {
  usual,  // the best of each ISA and the highest ISA of each technique, end to end; with threads
          // and as kernel the library's choice alone
  all,
  highest,  // of each technique the highest ISA that is available
  best,     // the library's own choice, and its best scalar one, with and without threads
};

struct RowChoice {
  std::string filter;  // regular expression for names of rows; empty for all
  VariantChoice variants = VariantChoice::all;
  std::vector<int> threads = {2};  // of threaded variants
  bool peers = true;
};

struct SkippedRow {
  std::string name;
  std::string reason;
};

/// Rows that equal the reference, and the reason why others are missing.
struct Selection {
  std::vector<TimedRow> rows;  // by case and input, the reference first
  std::vector<SkippedRow> skipped;
  std::vector<std::string> mismatches;
  int verified = 0;  // variants equal to the reference, counted once for each input
};

/// Compares every row that the choice names with the reference, on every input, before it may be
/// measured. The reference of a case and input comes along with any of its rows. Cases that are not
/// timed by default take part where the filter spells out their name, see is_requested(). Rows
/// point to `operations` and `inputs`. Throws std::invalid_argument for a malformed filter.
[[nodiscard]] Selection select_rows(const RowChoice& choice,
                                    const std::vector<Operation>& operations,
                                    const std::vector<TimedInput>& inputs);

/// The same, with mismatches on standard error. Throws UsageError for a malformed filter and,
/// saying why, where none of the rows that the filter names is left.
[[nodiscard]] Selection select_rows_or_explain(const RowChoice& choice,
                                               const std::vector<Operation>& operations,
                                               const std::vector<TimedInput>& inputs);

/// How many rows were skipped and why, on standard error.
void report_skipped(const Selection& selection);

/// Whether the library chooses this variant, for one thread or for several, of those that run here.
[[nodiscard]] bool is_default(const Operation& operation, const Variant& variant, Index width);

/// Whether a variant computes on single words or bytes, without vectors.
[[nodiscard]] bool is_scalar(const Variant& variant);

/// The row of this name, not verified again. It points to `operations` and `inputs`. Throws
/// std::runtime_error for a name of no row.
[[nodiscard]] TimedRow row_named(const std::string& name, const std::vector<Operation>& operations,
                                 std::span<const TimedInput> inputs);

}  // namespace thinbench
