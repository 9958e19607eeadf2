#include "techniques/passes.hpp"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace thinbench::detail {
namespace {

TEST(ForEachRun, visits_runs_of_columns_clipped_to_the_row_and_collects_changes) {
  using Visits = std::vector<std::pair<Index, std::uint64_t>>;
  Visits seen;
  const std::uint64_t changed =
      for_each_run(Band{2, 4, 0b1011, 10, 36}, [&](Index y, Index from, Index to) {
        seen.emplace_back(y, static_cast<std::uint64_t>(100 * from + to));
        return from == 30;
      });
  EXPECT_EQ(seen, (Visits{{2, 20}, {3, 20}, {2, 3036}, {3, 3036}}));
  EXPECT_EQ(changed, 0b1000U);
}

}  // namespace
}  // namespace thinbench::detail
