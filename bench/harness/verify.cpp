#include "harness/verify.hpp"

#include <map>
#include <utility>

#include "harness/crosscheck.hpp"

namespace thinbench {

Verifier::Verifier(std::vector<Row> rows)
    : rows_(std::move(rows)), verdicts_(rows_.size()), plans_(rows_.size()) {}

void Verifier::show(const TestImage& image) {
  const ConstByteView view = image.image.view();
  if (view.width != width_ || view.height != height_) {
    for (auto& plan : plans_) plan.reset();
    width_ = view.width;
    height_ = view.height;
  }
  std::map<std::string_view, Expected> expected;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (!verdicts_[row].first_mismatch.empty()) continue;
    if (!rows_[row].why_unavailable(width_).empty()) continue;
    const std::string_view operation = rows_[row].operation->name;
    auto found = expected.find(operation);
    if (found == expected.end()) {
      found = expected.emplace(operation, expected_of(operation, view)).first;
    }
    compare(row, image, found->second);
  }
}

void Verifier::compare(std::size_t row, const TestImage& image, const Expected& expected) {
  if (!plans_[row]) {
    plans_[row].emplace(*rows_[row].operation, *rows_[row].variant, width_, height_,
                        PlanOptions{rows_[row].threads});
  }
  ++verdicts_[row].compared;
  if (const auto mismatch = find_mismatch(*plans_[row], image.image.view(), expected)) {
    verdicts_[row].first_mismatch = rows_[row].name + ": " + image.name + ": " + *mismatch;
  }
}

VerifySummary summary_of(const Verifier& verifier) {
  VerifySummary summary;
  for (std::size_t row = 0; row < verifier.rows().size(); ++row) {
    const RowVerdict& verdict = verifier.verdict(row);
    if (!verdict.first_mismatch.empty()) {
      ++summary.failed;
    } else if (verdict.compared > 0) {
      ++summary.passed;
    } else {
      ++summary.skipped;
    }
  }
  return summary;
}

}  // namespace thinbench
