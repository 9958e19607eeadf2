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

TEST(BandActivity, rows_have_at_most_64_columns_which_cover_them) {
  for (const Index elements : {1, 63, 64, 65, 127, 128, 129, 1000}) {
    BandActivity activity({0, 1}, elements, 1);
    activity.restart();
    const Band band = activity.begin_sub_iteration(1).front();
    EXPECT_GE(band.column_elements * __builtin_popcountll(band.columns), elements) << elements;
    EXPECT_LT(band.column_elements * (__builtin_popcountll(band.columns) - 1), elements);
  }
}

TEST(BandActivity, bands_start_at_the_first_row_that_may_change) {
  BandActivity activity({1, 2 * kRows + 3}, 6, 1);
  activity.restart();
  const auto bands = activity.begin_sub_iteration(1);
  ASSERT_EQ(bands.size(), 3U);
  EXPECT_EQ(bands[0].first, 1);
  EXPECT_EQ(bands[0].last, 1 + kRows);
  EXPECT_EQ(bands[2].first, 1 + 2 * kRows);
  EXPECT_EQ(bands[2].last, 2 * kRows + 3);
}

TEST(BandActivity, empty_range_of_rows_has_no_cells) {
  BandActivity activity({1, 1}, 6, 1);
  activity.restart();
  EXPECT_TRUE(activity.begin_sub_iteration(2).empty());
  EXPECT_FALSE(activity.end_sub_iteration());
}

TEST(ChangingRows, exclude_the_first_and_the_last_row_if_the_border_is_kept) {
  const auto count = [](Index height, Border border) {
    const RowRange rows = changing_rows(height, border);
    return rows.last - rows.first;
  };
  EXPECT_EQ(changing_rows(9, Border::keep).first, 1);
  for (const Index height : {0, 1, 2, 3, 50}) {
    EXPECT_EQ(count(height, Border::background), height);
    EXPECT_EQ(count(height, Border::keep), std::max<Index>(0, height - 2)) << height;
  }
}

TEST(BandActivity, rows_without_elements_have_no_cells) {
  BandActivity activity({0, 5}, 0, 1);
  activity.restart();
  EXPECT_TRUE(activity.begin_sub_iteration(1).empty());
  EXPECT_FALSE(activity.end_sub_iteration());
}

TEST(Band, columns_of_elements_are_those_that_contain_them) {
  const Band band = {0, 1, 0, 3, 12};
  EXPECT_EQ(band.columns_of(0, 3), 0b1U);
  EXPECT_EQ(band.columns_of(2, 4), 0b11U);
  EXPECT_EQ(band.columns_of(6, 12), 0b1100U);
  EXPECT_EQ((Band{0, 1, 0, 1, 64}.columns_of(0, 64)), ~std::uint64_t{0});
}

}  // namespace
}  // namespace thinbench::detail
