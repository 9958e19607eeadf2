#include "harness/verify.hpp"

#include <map>
#include <utility>

#include "harness/crosscheck.hpp"

namespace thinbench {

Verifier::Verifier(std::vector<Row> rows)
    : rows_(std::move(rows)), verdicts_(rows_.size()), jobs_(rows_.size()) {}

void Verifier::show(const TestImage& image) {
  const ConstImageView view = image.image.view();
  if (view.width != width_ || view.height != height_) {
    for (auto& job : jobs_) job.reset();
    width_ = view.width;
    height_ = view.height;
  }
  std::map<const void*, Outcome> expected;  // by operation, or by a variant with its own reference
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (!verdicts_[row].first_mismatch.empty()) continue;
    const auto& [operation, variant, threads, name] = rows_[row];
    if (operation->takes != image.kind || !variant->unavailable_reason(width_).empty()) continue;
    const void* key = variant->own_reference ? static_cast<const void*>(variant) : operation;
    auto found = expected.find(key);
    if (found == expected.end()) {
      found = expected.emplace(key, expected_of(*operation, *variant, view)).first;
    }
    compare(row, image, found->second);
  }
}

void Verifier::compare(std::size_t row, const TestImage& image, const Outcome& expected) {
  std::unique_ptr<Job>& job = jobs_[row];
  if (!job) job = rows_[row].variant->make_job(width_, height_, rows_[row].threads);
  ++verdicts_[row].compared;
  if (const auto mismatch = find_mismatch(*job, image.image.view(), expected)) {
    verdicts_[row].first_mismatch = rows_[row].name + ": " + image.name + ": " + *mismatch;
  }
}

VerifySummary summary_of(const Verifier& verifier) {
  VerifySummary summary;
  for (std::size_t row = 0; row < verifier.rows().size(); ++row) {
    const VerificationResult& verdict = verifier.verdict(row);
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
