#include "timing/timed_row.hpp"

#include <algorithm>
#include <regex>
#include <set>
#include <thread>

#include "timing/timed_call.hpp"

namespace thinbench {
namespace {

std::vector<int> thread_counts() {
  const int cores = static_cast<int>(std::max(2U, std::thread::hardware_concurrency()));
  return cores == 2 ? std::vector{2} : std::vector{2, cores};
}

/// Whether `row` is the one of its technique and threads that a series of sizes shows. Nets are
/// left out: compiled to a circuit they take the time of the rule, evaluated they would take the
/// time of the study.
bool in_size_sweep(const Row& row) {
  if (row.operation->default_model != nullptr) return false;
  const auto same_kind = [&](const ThinningVariant& other) {
    return other.technique == row.variant->technique && other.threaded == row.variant->threaded;
  };
  Isa highest = Isa::kBaseline;
  for (const ThinningVariant& other : row.operation->variants) {
    if (same_kind(other) && isa_available(other.isa)) highest = std::max(highest, other.isa);
  }
  return row.variant->isa == highest;
}

std::string reference_name(const ThinningOperation& operation, const TimedInput& input) {
  return std::string(operation.name) + "/reference/baseline/1/end_to_end/" + input.name;
}

class Selector {
 public:
  Selector(const std::string& filter, const std::vector<TimedInput>& inputs)
      : pattern_(filter), inputs_(inputs), all_rows_(matching_rows("", thread_counts())) {}

  Selection select() {
    for (const TimedInput& input : inputs_) {
      for (const ThinningOperation& operation : thinning_operations()) add(operation, input);
    }
    return std::move(selection_);
  }

 private:
  void add(const ThinningOperation& operation, const TimedInput& input) {
    const std::string reference = reference_name(operation, input);
    std::optional<Expected> expected;
    const auto need_reference = [&]() -> const Expected& {
      if (!expected) {
        expected = expected_of(operation.name, input.image.view());
        selection_.rows.push_back(
            {reference, &operation, nullptr, 1, Scope::kEndToEnd, &input, expected->passes});
      }
      return *expected;
    };
    if (std::regex_search(reference, pattern_)) need_reference();
    for (const Row& row : all_rows_) {
      if (row.operation != &operation) continue;
      const std::vector<Scope> scopes = wanted_scopes(row, input);
      if (scopes.empty()) continue;
      if (admissible(row, input) && proved(row, input, need_reference())) {
        for (const Scope scope : scopes) add_timed(row, scope, input, expected->passes);
      }
    }
  }

  [[nodiscard]] std::vector<Scope> wanted_scopes(const Row& row, const TimedInput& input) const {
    if (input.size_sweep && !in_size_sweep(row)) return {};
    std::vector<Scope> scopes;
    for (const Scope scope : {Scope::kKernel, Scope::kEndToEnd}) {
      if (input.size_sweep && scope == Scope::kKernel) continue;
      if (std::regex_search(timed_name(row, scope, input), pattern_)) scopes.push_back(scope);
    }
    return scopes;
  }

  bool admissible(const Row& row, const TimedInput& input) {
    const std::string_view reason = row.why_unavailable(input.image.width());
    if (reason.empty()) return true;
    selection_.skipped.push_back({row.name + "/" + input.name, std::string(reason)});
    return false;
  }

  bool proved(const Row& row, const TimedInput& input, const Expected& expected) {
    const ConstByteView view = input.image.view();
    ThinningPlan plan(*row.operation, *row.variant, view.width, view.height, {row.threads});
    if (const auto mismatch = find_mismatch(plan, view, expected)) {
      selection_.mismatches.push_back(row.name + "/" + input.name + ": " + *mismatch);
      return false;
    }
    ++selection_.verified;
    return true;
  }

  static std::string timed_name(const Row& row, Scope scope, const TimedInput& input) {
    return row.name + "/" + std::string(scope_name(scope)) + "/" + input.name;
  }

  void add_timed(const Row& row, Scope scope, const TimedInput& input, int passes) {
    selection_.rows.push_back({timed_name(row, scope, input), row.operation, row.variant,
                               row.threads, scope, &input, passes});
  }

  std::regex pattern_;
  const std::vector<TimedInput>& inputs_;
  std::vector<Row> all_rows_;
  Selection selection_;
};

}  // namespace

Selection select_rows(const std::string& filter, const std::vector<TimedInput>& inputs) {
  static_cast<void>(matching_rows(filter, {2}));  // refuses a malformed filter with a clear message
  return Selector(filter, inputs).select();
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
