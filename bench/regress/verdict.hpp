// What an interval says: nothing but arithmetic.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace thinbench {

enum class Verdict { pass, fail, undecided, skipped };

/// How far a speed-up may fall: two builds in one job; against a baseline stored earlier on the
/// same kind of machine; against such a baseline on an image that does not fit the cache.
inline constexpr double kOneJobTolerance = 0.05;
inline constexpr double kStoredTolerance = 0.10;
inline constexpr double kBeyondCacheTolerance = 0.20;

/// Nothing was compared: no verdict, and never a green one.
inline constexpr int kNothingCompared = 4;

/// A speed-up divided by the one that it is compared with: below 1 for slower.
struct Change {
  double ratio = 1;
  double low = 1;
  double high = 1;
};

[[nodiscard]] std::string_view name_of(Verdict verdict);

/// `usual`, or more where source and destination together do not fit the cache.
[[nodiscard]] double tolerance_of(double usual, std::int64_t pixels, std::int64_t cache_kib);

/// FAIL where all of the interval is below 1 - tolerance, PASS where none of it is.
[[nodiscard]] Verdict judge(const Change& change, double tolerance);

/// What two runs say together: it takes both for FAIL, and one for PASS unless the other says FAIL.
[[nodiscard]] Verdict confirmed(Verdict first, Verdict again);

/// The worst; SKIPPED where nothing else was there.
[[nodiscard]] Verdict overall(const std::vector<Verdict>& verdicts);

/// 0 PASS, 1 FAIL, 3 INCONCLUSIVE, 4 SKIPPED.
[[nodiscard]] int exit_status(Verdict verdict);

}  // namespace thinbench
