// A row made ready: calling it is what the clock sees, nothing else.
#pragma once

#include <chrono>
#include <optional>

#include "timing/timed_row.hpp"

namespace thinbench {

/// Holds plan, input and output of a row. Calling allocates nothing, unless the row is the
/// reference.
class TimedCall {
 public:
  explicit TimedCall(const TimedRow& row) : row_(row), output_(input().width, input().height) {
    if (row.variant == nullptr) return;
    plan_.emplace(*row.operation, *row.variant, input().width, input().height,
                  PlanOptions{row.threads});
    plan_->load(input());
  }

  void operator()() {
    if (!plan_) {
      reference::find_thinning(row_.operation->name)(input(), output_.view());
    } else if (row_.scope == Scope::kKernel) {
      plan_->thin();
    } else {
      plan_->run(input(), output_.view());
    }
  }

 private:
  [[nodiscard]] ConstByteView input() const { return row_.input->image.view(); }

  const TimedRow& row_;
  ByteImage output_;
  std::optional<ThinningPlan> plan_;
};

}  // namespace thinbench
