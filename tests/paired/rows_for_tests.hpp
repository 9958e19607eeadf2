// An operation with variants of chosen techniques, and times for them.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "paired/plan.hpp"
#include "timing/broken_operation.hpp"

namespace thinbench {

/// Rows of one operation, reference first, with made-up seconds a call.
class RowsForTests {
 public:
  explicit RowsForTests(double reference_seconds) { add(nullptr, "reference", reference_seconds); }

  void with(std::string_view technique, double seconds, Isa isa = Isa::baseline, int threads = 1) {
    variants_.push_back(copy_variant(technique, false));
    variants_.back().isa = isa;
    variants_.back().threaded = threads > 1;
    add(&variants_.back(), technique, seconds, threads);
  }

  [[nodiscard]] const std::vector<CalibratedRow>& rows() const { return calibrated_; }

 private:
  void add(const Variant* variant, std::string_view technique, double seconds, int threads = 1) {
    const std::string isa(variant == nullptr ? "baseline" : variant->isa_label());
    timed_.push_back({row_name("copy", technique, isa, threads) + "/end_to_end/scene",
                      nullptr,
                      variant,
                      threads,
                      Scope::end_to_end,
                      nullptr,
                      {}});
    calibrated_.push_back({&timed_.back(), seconds, "0123456789abcdef"});
  }

  std::deque<Variant> variants_;
  std::deque<TimedRow> timed_;
  std::vector<CalibratedRow> calibrated_;
};

}  // namespace thinbench
