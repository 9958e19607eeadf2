#include "regress/verdict.hpp"

#include <algorithm>

namespace thinbench {
namespace {

bool has(const std::vector<Verdict>& verdicts, Verdict wanted) {
  return std::find(verdicts.begin(), verdicts.end(), wanted) != verdicts.end();
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return "PASS";
    case Verdict::kFail:
      return "FAIL";
    case Verdict::kUndecided:
      return "INCONCLUSIVE";
    case Verdict::kSkipped:
      return "SKIPPED";
  }
  return "";
}

double tolerance_of(double usual, std::int64_t pixels, std::int64_t cache_kib) {
  const bool fits = 2 * pixels <= 1024 * cache_kib;
  return fits ? usual : std::max(usual, kBeyondCacheTolerance);
}

Verdict judge(const Change& change, double tolerance) {
  const double limit = 1 - tolerance;
  if (change.high < limit) return Verdict::kFail;
  return change.low < limit ? Verdict::kUndecided : Verdict::kPass;
}

Verdict confirmed(Verdict first, Verdict again) {
  if (first == again || first == Verdict::kSkipped) return first;
  const bool one_fails = has({first, again}, Verdict::kFail);
  return !one_fails && has({first, again}, Verdict::kPass) ? Verdict::kPass : Verdict::kUndecided;
}

Verdict overall(const std::vector<Verdict>& verdicts) {
  for (const Verdict worst : {Verdict::kFail, Verdict::kUndecided, Verdict::kPass}) {
    if (has(verdicts, worst)) return worst;
  }
  return Verdict::kSkipped;
}

int exit_status(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return 0;
    case Verdict::kFail:
      return 1;
    case Verdict::kUndecided:
      return 3;
    case Verdict::kSkipped:
      break;
  }
  return kNothingCompared;
}

}  // namespace thinbench
