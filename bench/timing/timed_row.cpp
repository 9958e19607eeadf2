#include "timing/timed_row.hpp"

#include <algorithm>
#include <chrono>
#include <regex>
#include <thread>

#include "harness/crosscheck.hpp"
#include "support/heap.hpp"
#include "timing/progress.hpp"
#include "timing/timed_call.hpp"

namespace thinbench {
namespace {

std::vector<int> thread_counts() {
  const int cores = static_cast<int>(std::max(2U, std::thread::hardware_concurrency()));
  return cores == 2 ? std::vector{2} : std::vector{2, cores};
}

/// Whether no higher ISA of the row's technique and threads runs here.
bool is_highest_level(const Row& row) {
  const auto same_kind = [&](const Variant& other) {
    return other.technique == row.variant->technique && other.threaded == row.variant->threaded;
  };
  Isa highest = Isa::baseline;
  for (const Variant& other : row.operation->variants) {
    if (same_kind(other) && isa_available(other.isa)) highest = std::max(highest, other.isa);
  }
  return row.variant->isa == highest;
}

/// Series of sizes show the highest ISA of each technique.
bool in_size_sweep(const Row& row) {
  return row.operation->in_size_series && row.variant->for_series_of_sizes && is_highest_level(row);
}

std::string reference_name(const Operation& operation, const TimedInput& input) {
  return operation.name + "/reference/baseline/1/end_to_end/" + input.name;
}

/// The scopes in which a row is timed on an input, whatever the filter says.
std::vector<Scope> scopes_of(const Row& row, const TimedInput& input) {
  if (input.size_sweep && !in_size_sweep(row)) return {};
  if (input.size_sweep || !row.variant->has_kernel_scope) return {Scope::end_to_end};
  return {Scope::kernel, Scope::end_to_end};
}

class Selector {
 public:
  Selector(const std::string& filter, const std::vector<Operation>& operations,
           const std::vector<TimedInput>& inputs, Levels levels)
      : filter_(filter),
        pattern_(filter),
        operations_(operations),
        inputs_(inputs),
        all_rows_(matching_rows("", thread_counts(), operations)) {
    if (levels == Levels::highest) {
      std::erase_if(all_rows_, [](const Row& row) { return !is_highest_level(row); });
    }
  }

  Selection select() {
    std::vector<Task> tasks;
    for (const TimedInput& input : inputs_) {
      for (const Operation& operation : operations_) {
        if (is_requested(operation, filter_)) tasks.push_back(task_of(operation, input));
      }
    }
    double total = 0;
    for (const Task& task : tasks) total += task.pixels();
    Progress progress("verifying", total);
    for (const Task& task : tasks) carry_out(task, progress);
    return std::move(selection_);
  }

 private:
  struct WantedRow {
    const Row* row;
    std::vector<Scope> scopes;
  };

  /// A case on an input: what has to be verified and timed.
  struct Task {
    const Operation* operation;
    const TimedInput* input;
    bool reference;  // timed even without any variant
    std::vector<WantedRow> rows;

    /// The work it makes: the pixels to compute. The reference counts as one more row.
    [[nodiscard]] double pixels() const {
      const auto area = static_cast<double>(input->width() * input->height());
      const bool any = reference || !rows.empty();
      return area * static_cast<double>(rows.size() + (any ? 1 : 0));
    }
  };

  [[nodiscard]] Task task_of(const Operation& operation, const TimedInput& input) const {
    const bool shown = !input.size_sweep || operation.in_size_series;
    Task task{&operation,
              &input,
              shown && std::regex_search(reference_name(operation, input), pattern_),
              {}};
    for (const Row& row : all_rows_) {
      if (row.operation != &operation) continue;
      std::vector<Scope> scopes = wanted_scopes(row, input);
      if (!scopes.empty()) task.rows.push_back({&row, std::move(scopes)});
    }
    return task;
  }

  void carry_out(const Task& task, Progress& progress) {
    const TimedInput& input = *task.input;
    const double share = task.pixels() / static_cast<double>(task.rows.size() + 1);
    std::optional<Outcome> expected;
    const auto need_reference = [&]() -> const Outcome& {
      if (!expected) {
        const ConstImageView view = input.view(task.operation->takes);
        expected = outcome_of(*task.operation->reference(view.width, view.height, 1), view);
        add_timed({reference_name(*task.operation, input),
                   task.operation,
                   nullptr,
                   1,
                   Scope::end_to_end,
                   &input,
                   {}},
                  *expected);
        progress.advance(share);
      }
      return *expected;
    };
    if (task.reference) need_reference();
    for (const auto& [row, scopes] : task.rows) {
      std::optional<std::int64_t> plan_bytes;
      if (admissible(*row, input) && verified(*row, input, need_reference(), plan_bytes)) {
        for (const Scope scope : scopes) {
          add_timed({timed_name(*row, scope, input),
                     row->operation,
                     row->variant,
                     row->threads,
                     scope,
                     &input,
                     {},
                     plan_bytes},
                    *expected);
        }
      }
      progress.advance(share);
    }
  }

  [[nodiscard]] std::vector<Scope> wanted_scopes(const Row& row, const TimedInput& input) const {
    std::vector<Scope> scopes = scopes_of(row, input);
    std::erase_if(scopes, [&](Scope scope) {
      return !std::regex_search(timed_name(row, scope, input), pattern_);
    });
    return scopes;
  }

  bool admissible(const Row& row, const TimedInput& input) {
    const std::string reason = row.unavailable_reason(input.width());
    if (reason.empty()) return true;
    selection_.skipped.push_back({row.name + "/" + input.name, reason});
    return false;
  }

  /// `expected` is what the case's own reference gave; `plan_bytes` is set.
  bool verified(const Row& row, const TimedInput& input, const Outcome& expected,
                std::optional<std::int64_t>& plan_bytes) {
    const ConstImageView view = input.view(row.operation->takes);
    const std::optional<std::int64_t> before = heap_bytes_in_use();
    const auto job = row.variant->make_job(view.width, view.height, row.threads);
    const std::optional<std::int64_t> after = heap_bytes_in_use();
    // References and peers ask for memory while they run.
    if (before && after && !row.variant->is_peer) plan_bytes = *after - *before;
    std::optional<Outcome> own;
    if (row.variant->own_reference) own = expected_of(*row.operation, *row.variant, view);
    const Outcome& due = own ? *own : expected;
    std::optional<std::string> mismatch = find_mismatch(*job, view, due);
    if (!mismatch && row.variant->has_kernel_scope) {
      mismatch = find_kernel_mismatch(*job, view, due);
    }
    if (mismatch) {
      selection_.mismatches.push_back(row.name + "/" + input.name + ": " + *mismatch);
      return false;
    }
    ++selection_.verified;
    return true;
  }

  static std::string timed_name(const Row& row, Scope scope, const TimedInput& input) {
    return row.name + "/" + std::string(scope_name(scope)) + "/" + input.name;
  }

  void add_timed(TimedRow row, const Outcome& expected) {
    const bool on_its_own = row.variant != nullptr && row.variant->own_reference;
    if (!row.operation->counter.empty() && !on_its_own) row.counter = expected.numbers.front();
    selection_.rows.push_back(std::move(row));
  }

  std::string filter_;
  std::regex pattern_;
  const std::vector<Operation>& operations_;
  const std::vector<TimedInput>& inputs_;
  std::vector<Row> all_rows_;
  Selection selection_;
};

}  // namespace

Selection select_rows(const std::string& filter, const std::vector<Operation>& operations,
                      const std::vector<TimedInput>& inputs, Levels levels) {
  static_cast<void>(matching_rows(filter, {2}));  // rejects a malformed filter with a clear message
  return Selector(filter, operations, inputs, levels).select();
}

double seconds_of_one_call(const TimedRow& row) {
  TimedCall call(row);
  const auto timed = [&] {
    const auto start = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const double cold = timed();  // touches every page
  return cold > kSlowCall ? cold : timed();
}

}  // namespace thinbench
