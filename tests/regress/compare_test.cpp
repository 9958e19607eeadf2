#include "regress/compare.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "regress/made_up_runs.hpp"
#include "regress/table.hpp"

namespace thinbench {
namespace {

constexpr Rules kRules{false, 2048};
const std::string kFirst = row_for_tests(0);

Baseline baseline_of(const MeasuredRun& run) {
  Baseline baseline;
  update(baseline, run, {{"date", "2026-01-01"}, {"commit", "0123456789"}}, "for tests");
  return baseline;
}

const RegressionVerdict& row_of(const std::vector<RegressionVerdict>& rows,
                                const std::string& name) {
  return *std::find_if(rows.begin(), rows.end(),
                       [&](const RegressionVerdict& row) { return row.name == name; });
}

int number_of(const std::vector<RegressionVerdict>& rows, Verdict verdict) {
  return static_cast<int>(
      std::count_if(rows.begin(), rows.end(),
                    [&](const RegressionVerdict& row) { return row.verdict == verdict; }));
}

/// As ./study regress does it: what is not PASS is measured again, controls are heeded.
template <class Compare>
std::vector<RegressionVerdict> gated(const Compare& compare, Neighbour neighbour,
                                     std::uint64_t seed, double slowed) {
  const auto judged = [&](std::uint64_t run_seed) {
    const MeasuredRun run = run_for_tests(run_seed, slowed);
    std::vector<RegressionVerdict> rows = compare(run, run_seed);
    doubt(judge_controls(run, neighbour), rows);
    return rows;
  };
  std::vector<RegressionVerdict> rows = judged(seed);
  confirm(judged(seed + 1000), rows);
  return rows;
}

std::vector<RegressionVerdict> two_builds(std::uint64_t seed, double slowed) {
  return gated(
      [](const MeasuredRun& run, std::uint64_t run_seed) {
        return between(run_for_tests(run_seed + 5000), run, kRules);
      },
      Neighbour::next_process, seed, slowed);
}

std::vector<RegressionVerdict> against_stored(std::uint64_t seed, double slowed) {
  const Baseline baseline = baseline_of(run_for_tests(seed + 7000));
  return gated([&](const MeasuredRun& run,
                   std::uint64_t) { return against_baseline(run, baseline, kRules); },
               Neighbour::same_process, seed, slowed);
}

TEST(Gate, planted_slow_down_of_ten_percent_fails_between_two_builds_and_no_other_row_does) {
  const std::vector<RegressionVerdict> rows = two_builds(1, 0.10);
  EXPECT_EQ(row_of(rows, kFirst).verdict, Verdict::fail) << to_table(rows, true);
  EXPECT_EQ(number_of(rows, Verdict::fail), 1) << to_table(rows, true);
}

TEST(Gate, planted_slow_down_is_never_green_in_thirty_runs_and_mostly_fails) {
  int failed = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Verdict verdict = row_of(two_builds(seed, 0.10), kFirst).verdict;
    EXPECT_NE(verdict, Verdict::pass) << seed;
    failed += verdict == Verdict::fail ? 1 : 0;
  }
  EXPECT_GE(failed, 20);
}

TEST(Gate, same_build_against_itself_thirty_times_never_fails) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    EXPECT_EQ(number_of(two_builds(seed, 0), Verdict::fail), 0) << seed;
    EXPECT_EQ(number_of(against_stored(seed, 0), Verdict::fail), 0) << seed;
  }
}

TEST(Gate, stored_baseline_tells_a_slow_down_beyond_its_ten_percent) {
  EXPECT_EQ(row_of(against_stored(3, 0.25), kFirst).verdict, Verdict::fail);
}

TEST(Gate, faster_reference_is_named_where_the_speed_up_fell) {
  EXPECT_EQ(what_moved({1e5, 1e4}, {1e5, 1.12e4}), "row 12 % slower");
  EXPECT_EQ(what_moved({1e5, 1e4}, {8e4, 1e4}), "reference 20 % faster");
  EXPECT_EQ(what_moved({1e5, 1e4}, {9e4, 1.1e4}), "row 10 % slower, reference 10 % faster");
  EXPECT_EQ(what_moved({1e5, 1e4}, {1.02e5, 0.99e4}), "neither moved by 3 %");
}

TEST(Gate, threads_are_reported_and_judged_only_when_asked_for) {
  MeasuredRun now = run_for_tests(1, 0.5);
  now.rows[kFirst].threaded = true;
  const MeasuredRun before = run_for_tests(2);
  const RegressionVerdict skipped = row_of(between(before, now, kRules), kFirst);
  EXPECT_EQ(skipped.verdict, Verdict::skipped);
  EXPECT_EQ(skipped.reason, "threads: reported, not judged");
  EXPECT_EQ(row_of(between(before, now, {true, 2048}), kFirst).verdict, Verdict::fail);
}

TEST(Gate, rows_without_a_counterpart_or_of_another_picture_are_skipped) {
  MeasuredRun now = run_for_tests(1);
  const Baseline baseline = baseline_of(now);
  now.rows.erase(row_for_tests(1));
  now.rows[kFirst].input_hash = "another";
  now.rows["copy/new/avx2/1/kernel/scene"] = now.rows[row_for_tests(2)];
  now.rows["copy/new/avx2/1/kernel/scene"].name = "copy/new/avx2/1/kernel/scene";
  const std::vector<RegressionVerdict> rows = against_baseline(now, baseline, kRules);
  EXPECT_EQ(row_of(rows, row_for_tests(1)).reason, "not measured in this run");
  EXPECT_EQ(row_of(rows, kFirst).reason, "another picture than in the baseline");
  EXPECT_EQ(row_of(rows, "copy/new/avx2/1/kernel/scene").reason,
            "new: there is nothing to compare with");
  EXPECT_EQ(number_of(rows, Verdict::skipped), 3);
}

TEST(Gate, row_with_other_neighbours_is_in_doubt_rather_than_slower) {
  MeasuredRun now = run_for_tests(1, 0.5);
  now.rows.erase(row_for_tests(1));
  const RegressionVerdict row = row_of(between(run_for_tests(2), now, kRules), kFirst);
  EXPECT_EQ(row.verdict, Verdict::undecided);
  EXPECT_EQ(row.reason, "measured beside other rows than before");
}

TEST(Gate, row_that_some_process_did_not_measure_is_skipped) {
  MeasuredRun now = run_for_tests(1, 0.5);
  now.rows[kFirst].logs.pop_back();
  EXPECT_EQ(row_of(between(run_for_tests(2), now, kRules), kFirst).reason,
            "not measured by every process");
}

TEST(Gate, simd_slower_than_scalar_code_of_its_kind_fails) {
  MeasuredRun run;
  run.processes = kProcesses;
  const auto add = [&](const std::string& name, double speedup) {
    const std::vector<double> logs(kProcesses, std::log(speedup));
    run.rows[name] = {name, false, "hash", 100, logs, {1e5, 1e5 / speedup}};
  };
  add("copy/bitpacked/baseline/1/kernel/scene", 10);
  add("copy/simd_bitpacked/avx2/1/kernel/scene", 9);
  add("copy/simd_bitpacked/avx512/1/kernel/scene", 11);
  add("copy/simd_bytes/avx2/1/kernel/scene", 2);
  add("copy/simd_bytes/baseline/1/kernel/scene", 0.9);
  const std::vector<RegressionVerdict> rows = against_scalar(run);
  EXPECT_EQ(rows.size(), 4U);
  EXPECT_EQ(row_of(rows, "copy/simd_bitpacked/avx2/1/kernel/scene").verdict, Verdict::fail);
  EXPECT_EQ(row_of(rows, "copy/simd_bitpacked/avx512/1/kernel/scene").verdict, Verdict::pass);
  EXPECT_EQ(row_of(rows, "copy/simd_bytes/avx2/1/kernel/scene").verdict, Verdict::pass);
  EXPECT_EQ(row_of(rows, "copy/simd_bytes/baseline/1/kernel/scene").verdict, Verdict::fail);
}

}  // namespace
}  // namespace thinbench
