#include "thinning/iterate.hpp"

#include <gtest/gtest.h>

namespace thinbench {
namespace {

std::vector<Index> listed(std::span<const Index> bands) {
  return {bands.begin(), bands.end()};
}

TEST(BandActivity, first_two_steps_visit_every_band) {
  BandActivity activity(5 * BandActivity::kRows);
  activity.restart();
  for (int step = 1; step <= 2; ++step) {
    EXPECT_EQ(activity.begin_step(1).size(), 5U);
    for (Index band = 0; band < 5; ++band) activity.set_changed(band, false);
    EXPECT_FALSE(activity.end_step());
  }
  EXPECT_TRUE(activity.begin_step(1).empty());
}

TEST(BandActivity, a_change_wakes_the_band_and_its_neighbours_for_one_cycle) {
  BandActivity activity(6 * BandActivity::kRows);
  activity.restart();
  for (int step = 1; step <= 2; ++step) {
    for (const Index band : activity.begin_step(1))
      activity.set_changed(band, step == 2 && band == 3);
    EXPECT_EQ(activity.end_step(), step == 2);
  }
  EXPECT_EQ(listed(activity.begin_step(1)), (std::vector<Index>{2, 3, 4}));
}

TEST(BandActivity, a_cycle_of_two_keeps_bands_awake_for_two_steps) {
  BandActivity activity(6 * BandActivity::kRows);
  activity.restart();
  for (int step = 1; step <= 4; ++step) {
    for (const Index band : activity.begin_step(2))
      activity.set_changed(band, step == 3 && band == 0);
    activity.end_step();
  }
  EXPECT_EQ(listed(activity.begin_step(2)), (std::vector<Index>{0, 1}));
  for (const Index band : {0, 1}) activity.set_changed(band, false);
  activity.end_step();
  EXPECT_TRUE(activity.begin_step(2).empty());
}

}  // namespace
}  // namespace thinbench
