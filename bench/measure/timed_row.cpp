#include "measure/timed_row.hpp"

#include <algorithm>
#include <iostream>
#include <map>
#include <regex>

#include "core/thread_team.hpp"
#include "harness/verify.hpp"
#include "support/progress.hpp"
#include "support/text.hpp"
#include "support/usage.hpp"
#include "thinbench/isa.hpp"

namespace thinbench {
namespace {

/// Whether no other variant that runs on this width and fulfils the condition is better.
template <class Condition, class Better>
bool is_best(const Operation& operation, const Variant& variant, Index width,
             const Condition& condition, const Better& better) {
  if (variant.is_peer || !condition(variant)) return false;
  return std::none_of(
      operation.variants.begin(), operation.variants.end(), [&](const Variant& other) {
        return !other.is_peer && other.threaded == variant.threaded && condition(other) &&
               other.unavailable_reason(width).empty() && better(other, variant);
      });
}

bool is_highest_isa(const Row& row, Index width) {
  return is_best(
      *row.operation, *row.variant, width,
      [&](const Variant& other) { return other.technique == row.variant->technique; },
      [](const Variant& a, const Variant& b) { return a.isa > b.isa; });
}

bool has_higher_priority(const Variant& a, const Variant& b) {
  return a.priority > b.priority;
}

bool is_default(const Row& row, Index width) {
  return is_default(*row.operation, *row.variant, width);
}

bool is_best_scalar(const Row& row, Index width) {
  return is_best(*row.operation, *row.variant, width, is_scalar, has_higher_priority);
}

bool is_best_of_isa(const Row& row, Index width) {
  const auto same_isa = [&](const Variant& other) { return other.isa == row.variant->isa; };
  return is_best(*row.operation, *row.variant, width, same_isa, has_higher_priority);
}

/// Whether the library would use threads.
bool threads_pay(const Row& row, const TimedInput& input) {
  const Index width = input.width();
  return width * input.height() >= detail::kMinPixelsForThreads && is_default(row, width);
}

bool is_usual(const Row& row, Index width) {
  return is_best_of_isa(row, width) || is_highest_isa(row, width) || is_best_scalar(row, width);
}

bool is_chosen(const Row& row, const TimedInput& input, VariantChoice choice) {
  if (row.variant->is_peer || choice == VariantChoice::all) return true;
  if (row.variant->threaded && choice != VariantChoice::best) return threads_pay(row, input);
  if (choice == VariantChoice::usual) return is_usual(row, input.width());
  if (choice == VariantChoice::highest) return is_highest_isa(row, input.width());
  return is_default(row, input.width()) || is_best_scalar(row, input.width());
}

std::string reference_name(const Operation& operation, const TimedInput& input) {
  return operation.name + "/reference/baseline/1/end_to_end/" + input.name;
}

std::string timed_name(const Row& row, Scope scope, const TimedInput& input) {
  return row.name + "/" + std::string(scope_name(scope)) + "/" + input.name;
}

/// Throws std::invalid_argument for a malformed filter.
void check_filter(const std::string& filter) {
  static_cast<void>(matching_rows(filter, {1}, {}));
}

class Selector {
 public:
  Selector(const RowChoice& choice, const std::vector<Operation>& operations,
           const std::vector<TimedInput>& inputs)
      : choice_(choice), operations_(operations), inputs_(inputs) {
    all_rows_ = matching_rows("", choice.threads, operations);
    check_filter(choice.filter);
    pattern_ = std::regex(choice.filter);
  }

  Selection select() {
    const std::vector<Task> tasks = all_tasks();
    double pixels = 0;
    for (const Task& task : tasks) pixels += task.pixels();
    Progress progress("verifying", pixels);
    for (const Task& task : tasks) carry_out(task, progress);
    return std::move(selection_);
  }

  /// Whether any row is chosen, available or not.
  [[nodiscard]] bool chooses_rows() const {
    const std::vector<Task> tasks = all_tasks();
    return std::any_of(tasks.begin(), tasks.end(), [](const Task& task) { return task.reference; });
  }

 private:
  struct ChosenRow {
    const Row* row;
    std::vector<Scope> scopes;
  };

  /// A case on an input.
  struct Task {
    const Operation* operation;
    const TimedInput* input;
    std::vector<ChosenRow> rows;
    bool reference;  // needed at all

    [[nodiscard]] double pixels() const {
      const auto area = static_cast<double>(input->width() * input->height());
      return area * static_cast<double>(rows.size() + (reference ? 1 : 0));
    }
  };

  [[nodiscard]] std::vector<Task> all_tasks() const {
    std::vector<Task> tasks;
    for (const TimedInput& input : inputs_) {
      for (const Operation& operation : operations_) {
        if (is_requested(operation, choice_.filter)) tasks.push_back(task_of(operation, input));
      }
    }
    return tasks;
  }

  [[nodiscard]] Task task_of(const Operation& operation, const TimedInput& input) const {
    Task task{&operation, &input, {}, false};
    for (const Row& row : all_rows_) {
      if (row.operation != &operation || (row.variant->is_peer && !choice_.peers)) continue;
      if (!is_chosen(row, input, choice_.variants)) continue;
      std::vector<Scope> scopes = matching_scopes(row, input);
      if (!scopes.empty()) task.rows.push_back({&row, std::move(scopes)});
    }
    task.reference =
        !task.rows.empty() || std::regex_search(reference_name(operation, input), pattern_);
    return task;
  }

  [[nodiscard]] std::vector<Scope> matching_scopes(const Row& row, const TimedInput& input) const {
    std::vector<Scope> scopes = {Scope::end_to_end};
    const bool wanted = choice_.variants != VariantChoice::usual || is_default(row, input.width());
    if (row.variant->has_kernel_scope && wanted) scopes.insert(scopes.begin(), Scope::kernel);
    std::erase_if(scopes, [&](Scope scope) {
      return !std::regex_search(timed_name(row, scope, input), pattern_);
    });
    return scopes;
  }

  void carry_out(const Task& task, Progress& progress) {
    if (!task.reference) return;
    const TimedInput& input = *task.input;
    const ConstImageView view = input.view(*task.operation);
    const double share = task.pixels() / static_cast<double>(task.rows.size() + 1);
    const Outcome expected =
        outcome_of(*task.operation->reference(view.width, view.height, 1), view);
    add({reference_name(*task.operation, input), task.operation, nullptr, 1, Scope::end_to_end,
         &input},
        expected);
    progress.advance(share);
    for (const auto& [row, scopes] : task.rows) {
      if (is_available(*row, input) && is_verified(*row, view, input, expected)) {
        for (const Scope scope : scopes) {
          add({timed_name(*row, scope, input), row->operation, row->variant, row->threads, scope,
               &input},
              expected);
        }
      }
      progress.advance(share);
    }
  }

  bool is_available(const Row& row, const TimedInput& input) {
    const std::string reason = row.unavailable_reason(input.width());
    if (reason.empty()) return true;
    selection_.skipped.push_back({row.name + "/" + input.name, reason});
    return false;
  }

  /// `expected` is what the case's own reference gave.
  bool is_verified(const Row& row, const ConstImageView& view, const TimedInput& input,
                   const Outcome& expected) {
    const auto job = row.variant->make_job(view.width, view.height, row.threads);
    const bool has_own = static_cast<bool>(row.variant->own_reference);
    const Outcome own = has_own ? expected_of(*row.operation, *row.variant, view) : Outcome{};
    std::optional<std::string> mismatch = find_mismatch(*job, view, has_own ? own : expected);
    if (!mismatch && row.variant->has_kernel_scope) {
      mismatch = find_kernel_mismatch(*job, view, has_own ? own : expected);
    }
    if (mismatch) {
      selection_.mismatches.push_back(row.name + "/" + input.name + ": " + *mismatch);
    } else {
      ++selection_.verified;
    }
    return !mismatch;
  }

  void add(TimedRow row, const Outcome& expected) {
    const bool own_reference = row.variant != nullptr && row.variant->own_reference;
    if (row.operation->counts_iterations && !own_reference) {
      row.iterations = expected.numbers.front();
    }
    selection_.rows.push_back(std::move(row));
  }

  const RowChoice& choice_;
  const std::vector<Operation>& operations_;
  const std::vector<TimedInput>& inputs_;
  std::regex pattern_;
  std::vector<Row> all_rows_;
  Selection selection_;
};

/// Rows that are skipped, by reason.
std::map<std::string, int> reasons_of(const Selection& selection) {
  std::map<std::string, int> reasons;
  for (const SkippedRow& row : selection.skipped) ++reasons[row.reason];
  return reasons;
}

/// Whether there is a row that the filter names, and not only the references of others.
bool has_named_rows(const Selection& selection, const std::string& filter) {
  const std::regex pattern(filter);
  return std::any_of(selection.rows.begin(), selection.rows.end(), [&](const TimedRow& row) {
    return row.variant != nullptr || std::regex_search(row.name, pattern);
  });
}

/// Why there is no such row.
std::string explanation(const RowChoice& choice, const Selection& selection,
                        const std::vector<Operation>& operations,
                        const std::vector<TimedInput>& inputs) {
  const std::string filter = "the filter '" + choice.filter + "'";
  if (!selection.skipped.empty()) {
    return "every row that matches " + filter +
           " is skipped: " + reasons_of(selection).begin()->first;
  }
  RowChoice all = choice;
  all.variants = VariantChoice::all;
  if (Selector(all, operations, inputs).chooses_rows()) {
    return "no usual row matches " + filter +
           "; all variants (--all of ./study, --variants all) have one";
  }
  return "no row matches " + filter + "; see 'thinbench-study list --variants'";
}

}  // namespace

bool is_default(const Operation& operation, const Variant& variant, Index width) {
  return is_best(
      operation, variant, width, [](const Variant&) { return true; }, has_higher_priority);
}

bool is_scalar(const Variant& variant) {
  return variant.isa == Isa::baseline && !variant.technique.starts_with("simd") &&
         variant.technique != "autovec";
}

Selection select_rows(const RowChoice& choice, const std::vector<Operation>& operations,
                      const std::vector<TimedInput>& inputs) {
  return Selector(choice, operations, inputs).select();
}

Selection select_rows_or_explain(const RowChoice& choice, const std::vector<Operation>& operations,
                                 const std::vector<TimedInput>& inputs) {
  checked_usage([&] { check_filter(choice.filter); }, "--filter: ");
  checked_usage(&isa_cap);
  Selection selection = select_rows(choice, operations, inputs);
  for (const std::string& mismatch : selection.mismatches) {
    std::cerr << "not equal to the reference, not measured: " << mismatch << '\n';
  }
  if (selection.mismatches.empty() && !has_named_rows(selection, choice.filter)) {
    throw UsageError(explanation(choice, selection, operations, inputs));
  }
  return selection;
}

void report_skipped(const Selection& selection) {
  for (const auto& [reason, count] : reasons_of(selection)) {
    std::cerr << "skipped " << counted(count, "row") << ": " << reason << '\n';
  }
}

}  // namespace thinbench
