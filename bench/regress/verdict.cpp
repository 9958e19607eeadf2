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
    case Verdict::pass:
      return "PASS";
    case Verdict::fail:
      return "FAIL";
    case Verdict::undecided:
      return "INCONCLUSIVE";
    case Verdict::skipped:
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
  if (change.high < limit) return Verdict::fail;
  return change.low < limit ? Verdict::undecided : Verdict::pass;
}

Verdict confirmed(Verdict first, Verdict again) {
  if (first == again || first == Verdict::skipped) return first;
  const bool one_fails = has({first, again}, Verdict::fail);
  return !one_fails && has({first, again}, Verdict::pass) ? Verdict::pass : Verdict::undecided;
}

Verdict overall(const std::vector<Verdict>& verdicts) {
  for (const Verdict worst : {Verdict::fail, Verdict::undecided, Verdict::pass}) {
    if (has(verdicts, worst)) return worst;
  }
  return Verdict::skipped;
}

int exit_status(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return 0;
    case Verdict::fail:
      return 1;
    case Verdict::undecided:
      return 3;
    case Verdict::skipped:
      break;
  }
  return kNothingCompared;
}

}  // namespace thinbench
