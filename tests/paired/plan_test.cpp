#include "paired/plan.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "paired/rows_for_tests.hpp"

namespace thinbench {
namespace {

using Strings = std::multiset<std::string>;

/// "technique>technique against" of all pairs that are no controls.
Strings pairs_of(const Group& group) {
  const auto technique = [&](std::size_t entry) {
    const std::string& name = group.entries[entry].name;
    return name.substr(5, name.find('/', 5) - 5);
  };
  Strings pairs;
  for (const Pair& pair : group.pairs) {
    if (group.entries[pair.row].role != Role::row) continue;
    pairs.insert(technique(pair.row) + ">" + technique(pair.base) + " " + pair.against);
  }
  return pairs;
}

TEST(Plan, every_row_is_paired_with_reference_best_scalar_and_best_autovec) {
  RowsForTests rows(1e-3);
  rows.with("lut", 5e-4);
  rows.with("bitpacked", 1e-4);
  rows.with("autovec", 2e-4, Isa::avx2);
  rows.with("simd_bytes", 1e-5, Isa::avx2);
  EXPECT_EQ(pairs_of(plan_group(rows.rows(), {})),
            (Strings{"lut>reference reference", "bitpacked>reference reference",
                     "autovec>reference reference", "simd_bytes>reference reference",
                     "lut>bitpacked best_scalar", "autovec>bitpacked best_scalar",
                     "simd_bytes>bitpacked best_scalar", "lut>autovec best_autovec",
                     "bitpacked>autovec best_autovec", "simd_bytes>autovec best_autovec"}));
}

TEST(Plan, epochs_of_all_short_rows_last_equally_long_and_long_calls_are_made_once) {
  RowsForTests rows(1e-2);
  rows.with("lut", 1e-4);
  rows.with("simd_bytes", 1e-5, Isa::avx2);
  const Group group = plan_group(rows.rows(), {});
  EXPECT_EQ(group.entries[0].calls, 1);
  EXPECT_TRUE(group.entries[0].long_call);
  EXPECT_EQ(group.entries[1].calls, 3);
  EXPECT_EQ(group.entries[2].calls, 30);
  EXPECT_FALSE(group.entries[2].long_call);
}

TEST(Plan, anchor_is_the_fastest_row_on_one_thread_and_controls_are_the_next) {
  RowsForTests rows(1e-2);
  rows.with("lut", 1e-4);
  rows.with("simd_bytes", 2e-5, Isa::avx2);
  rows.with("simd_runs", 1e-5, Isa::avx2, 2);
  const Group group = plan_group(rows.rows(), {});
  EXPECT_EQ(group.anchor, 2U);
  const auto control = std::find_if(group.entries.begin(), group.entries.end(),
                                    [](const Entry& entry) { return entry.role == Role::same; });
  ASSERT_NE(control, group.entries.end());
  EXPECT_EQ(control->name, group.entries[1].name);
}

TEST(Plan, slowed_control_makes_11_calls_for_10) {
  for (const double seconds : {1e-6, 3e-5, 9e-4, 5e-3}) {
    RowsForTests rows(1e-2);
    rows.with("lut", seconds);
    const Entry slowed = plan_group(rows.rows(), {}).entries.back();
    EXPECT_EQ(slowed.role, Role::slowed);
    EXPECT_EQ(slowed.calls * 10, slowed.counted * 11) << seconds;
  }
}

TEST(Plan, rounds_keep_to_the_budget_but_are_three_at_least) {
  RowsForTests rows(1e-3);
  rows.with("lut", 1e-4);
  EXPECT_EQ(plan_group(rows.rows(), {41, 100}).rounds, 41);
  EXPECT_EQ(plan_group(rows.rows(), {41, 0}).rounds, 3);
  EXPECT_EQ(plan_group(rows.rows(), {2, 0}).rounds, 2);
  const Group group = plan_group(rows.rows(), {41, 0.1});
  EXPECT_GT(group.rounds, 3);
  EXPECT_LE(group.seconds, 0.1);
}

TEST(Plan, short_rows_are_visited_more_often_beside_long_calls) {
  RowsForTests rows(1);
  rows.with("lut", 1e-4);
  EXPECT_EQ(plan_group(rows.rows(), {}).sweeps, kMostSweeps);
  RowsForTests all_short(1e-4);
  all_short.with("lut", 1e-4);
  EXPECT_EQ(plan_group(all_short.rows(), {}).sweeps, kFewestSweeps);
}

}  // namespace
}  // namespace thinbench
