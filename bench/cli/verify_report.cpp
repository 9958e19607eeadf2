#include "cli/verify_report.hpp"

namespace thinbench {
namespace {

void print_verdict(const Row& row, const VerificationResult& verdict, std::ostream& out) {
  if (!verdict.first_mismatch.empty()) {
    out << "mismatch: " << verdict.first_mismatch;
    if (verdict.first_mismatch.back() != '\n') out << '\n';
  } else if (verdict.compared == 0) {
    const std::string reason = row.unavailable_reason(0);
    out << "skipped: " << row.name << ": "
        << (reason.empty() ? "every image is wider than its limit" : reason) << '\n';
  }
}

}  // namespace

int report_verdicts(const Verifier& verifier, std::ostream& out) {
  for (std::size_t row = 0; row < verifier.rows().size(); ++row) {
    print_verdict(verifier.rows()[row], verifier.verdict(row), out);
  }
  const VerifySummary summary = summary_of(verifier);
  out << summary.passed << " passed, " << summary.failed << " failed, " << summary.skipped
      << " skipped" << std::endl;
  if (summary.passed + summary.failed == 0) {
    throw UsageError("nothing was verified: none of the matching rows is available here");
  }
  return summary.failed > 0 ? kFailure : kSuccess;
}

}  // namespace thinbench
