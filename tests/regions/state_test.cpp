// States of the operations on objects and holes.
#include "regions/state.hpp"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "holes.hpp"
#include "support/variant_of.hpp"

namespace thinbench::detail {
namespace {

void expect_equal(const RegionLists& found, const reference::Regions& expected) {
  EXPECT_TRUE(std::equal(found.holes.begin(), found.holes.end(), expected.holes.begin(),
                         expected.holes.end()));
  EXPECT_TRUE(std::equal(found.objects.begin(), found.objects.end(), expected.objects.begin(),
                         expected.objects.end()));
}

/// Noise, on which a kernel gives up after some rows, below objects, on which it does not.
ByteImage noise_below_blocks(Index height) {
  ByteImage image = noise_image(200, height, 50, 20, 7);
  const ByteImage noise = noise_image(200, height, 50, 1, 8);
  for (Index y = height / 3; y < height; ++y) {
    std::copy_n(noise.view().row(y), 200, image.view().row(y));
  }
  return image;
}

TEST(RegionsState, components_are_the_same_wherever_a_kernel_gives_up) {
  for (const RegionsVariant& variant : study::operation_of(RegionsTask::components).variants) {
    if (!unavailable_reason(variant, 200).empty()) continue;
    for (const Index height : {20, 40, 47, 48, 49, 50, 60, 97, 150}) {
      const ByteImage image = noise_below_blocks(height);
      const ByteImage blocks = noise_image(200, height, 50, 20, 7);
      const auto state = make_state(variant, 200, height, {RegionsTask::components}, 2);
      for (const ByteImage* one : {&image, &blocks, &image}) {
        state->load(one->view());
        state->compute();
        expect_equal({state->regions().objects, {}},
                     {reference::components(one->view()).objects, {}});
      }
    }
  }
}

TEST(RegionsState, fills_holes_up_to_an_area) {
  const RegionsTask tasks[] = {RegionsTask::fill, RegionsTask::fill_four};
  for (const RegionsTask task : tasks) {
    for (const int percent : {30, 45, 60}) {
      const ByteImage image = noise_image(190, 90, percent, 2, 6);
      ByteImage expected(190, 90);
      ByteImage found(190, 90);
      for (const std::int64_t max_area : {0, 4, 20, 4000}) {
        reference::fill_small_holes(image.view(), expected.view(), task == RegionsTask::fill_four,
                                    max_area);
        for (const RegionsVariant& variant : operation_of(task).variants) {
          if (!unavailable_reason(variant, 190).empty()) continue;
          const auto state = make_state(variant, 190, 90, {task, max_area}, 1);
          state->load(image.view());
          state->compute();
          state->store(found.view());
          ASSERT_TRUE(equal(found.view(), expected.view()))
              << name_of(variant) << ", " << percent << " %, up to " << max_area;
        }
      }
    }
  }
}

TEST(RegionsState, rejects_results_of_other_tasks) {
  const auto state_of = [](RegionsTask task, std::string_view technique) {
    return make_state(variant_of(study::operation_of(task).variants, technique), 9, 9, {task}, 1);
  };
  ByteImage image(9, 9);
  for (const char* technique : {"union_find", "bitpacked_runs"}) {
    EXPECT_THROW((void)state_of(RegionsTask::holes, technique)->number(), std::logic_error);
    EXPECT_THROW(state_of(RegionsTask::components, technique)->store(image.view()),
                 std::logic_error);
    EXPECT_THROW((void)state_of(RegionsTask::fill, technique)->regions(), std::logic_error);
  }
  EXPECT_THROW((void)state_of(RegionsTask::euler_eight, "lut")->regions(), std::logic_error);
}

}  // namespace
}  // namespace thinbench::detail
