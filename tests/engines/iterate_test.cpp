#include "engines/iterate.hpp"

#include <gtest/gtest.h>

namespace thinbench::detail {
namespace {

constexpr Index kRows = BandActivity::kRows;

/// Visits the active cells; `changes(band)` has a bit for every column that changes.
template <class Changes>
std::vector<std::pair<Index, std::uint64_t>> visit(BandActivity& activity, int lookback,
                                                   const Changes& changes) {
  std::vector<std::pair<Index, std::uint64_t>> visited;
  const auto bands = activity.begin_sub_iteration(lookback);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const Index band = bands[i].first / kRows;
    visited.emplace_back(band, bands[i].columns);
    activity.set_changed(i, changes(band) & bands[i].columns);
  }
  activity.end_sub_iteration();
  return visited;
}

constexpr auto kNothing = [](Index) { return std::uint64_t{0}; };
using Visits = std::vector<std::pair<Index, std::uint64_t>>;

TEST(BandActivity, first_two_sub_iterations_visit_every_cell) {
  BandActivity activity({0, 3 * kRows - 5}, 6, 1);
  for (int repeat = 0; repeat < 2; ++repeat) {
    activity.restart();
    const Visits everything = {{0, 0b111111}, {1, 0b111111}, {2, 0b111111}};
    EXPECT_EQ(visit(activity, 1, kNothing), everything);
    EXPECT_EQ(visit(activity, 1, kNothing), everything);
    EXPECT_TRUE(visit(activity, 1, kNothing).empty());
  }
}

TEST(BandActivity, change_activates_the_cell_and_its_eight_neighbours_for_one_sub_iteration) {
  BandActivity activity({0, 6 * kRows}, 6, 1);
  activity.restart();
  visit(activity, 1, kNothing);
  visit(activity, 1, [](Index band) { return std::uint64_t{band == 3 ? 0b001000U : 0U}; });
  EXPECT_EQ(visit(activity, 1, kNothing), (Visits{{2, 0b011100}, {3, 0b011100}, {4, 0b011100}}));
  EXPECT_TRUE(visit(activity, 1, kNothing).empty());
}

TEST(BandActivity, lookback_of_two_keeps_cells_active_for_two_sub_iterations) {
  BandActivity activity({0, 6 * kRows}, 2, 1);
  activity.restart();
  visit(activity, 2, kNothing);
  visit(activity, 2, kNothing);
  visit(activity, 2, [](Index band) { return std::uint64_t{band == 0 ? 1U : 0U}; });
  EXPECT_EQ(visit(activity, 2, kNothing), (Visits{{0, 0b11}, {1, 0b11}}));
  EXPECT_EQ(visit(activity, 2, kNothing), (Visits{{0, 0b11}, {1, 0b11}}));
  EXPECT_TRUE(visit(activity, 2, kNothing).empty());
}

}  // namespace
}  // namespace thinbench::detail
