// What a verification found, printed; and the exit status that follows.
#pragma once

#include "cli/command.hpp"
#include "harness/verify.hpp"

namespace thinbench {

/// Skipped rows with the reason, mismatches, and "N passed, M failed, K skipped" as the last line.
/// kFailure where a row differs from its reference, else kSuccess; throws UsageError where no row
/// ran.
int report_verdicts(const Verifier& verifier, std::ostream& out);

}  // namespace thinbench
