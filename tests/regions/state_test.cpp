// States of the operations on objects and holes.
#include "regions/state.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "holes.hpp"
#include "support/variant_of.hpp"

namespace thinbench::detail {
namespace {

/// Noise, on which a kernel gives up after some rows, below objects, on which it does not.
ByteImage noise_below_blocks(Index height) {
  ByteImage image = noise_image(200, height, 50, 20, 7);
  const ByteImage noise = noise_image(200, height, 50, 1, 8);
  for (Index y = height / 3; y < height; ++y) {
    std::copy_n(noise.view().row(y), 200, image.view().row(y));
  }
  return image;
}

TEST(ListState, finds_the_same_objects_wherever_a_kernel_gives_up) {
  for (const auto& variant : operation_of(ListParameters{false}).variants) {
    if (!unavailable_reason(variant, 200).empty()) continue;
    for (const Index height : {20, 40, 47, 48, 49, 50, 60, 97, 150}) {
      const ByteImage image = noise_below_blocks(height);
      const ByteImage blocks = noise_image(200, height, 50, 20, 7);
      const auto state = make_state(variant, 200, height, {false}, 2);
      for (const ByteImage* one : {&image, &blocks, &image}) {
        Regions found;
        state->run(one->view(), found);
        EXPECT_EQ(found.objects, reference::objects(one->view()).objects);
        EXPECT_TRUE(found.holes.empty());
      }
    }
  }
}

TEST(FillState, fills_holes_up_to_an_area) {
  for (const Connectivity objects : {Connectivity::eight, Connectivity::four}) {
    for (const int percent : {30, 45, 60}) {
      const ByteImage image = noise_image(190, 90, percent, 2, 6);
      const ByteImage first_image = noise_image(190, 90, percent, 2, 7);
      ByteImage expected(190, 90);
      ByteImage found(190, 90);
      for (const std::int64_t max_area : {0, 4, 20, 4000}) {
        reference::fill_small_holes(image.view(), expected.view(), objects == Connectivity::four,
                                    max_area);
        const HoleFilling parameters = {objects, max_area};
        for (const auto& variant : operation_of(parameters).variants) {
          if (!unavailable_reason(variant, 190).empty()) continue;
          const auto state = make_state(variant, 190, 90, parameters, 1);
          state->run(first_image.view(), found.view());
          state->run(image.view(), found.view());
          ASSERT_TRUE(equal(found.view(), expected.view()))
              << name_of(variant) << ", " << percent << " %, up to " << max_area;
        }
      }
    }
  }
}

/// Large enough for non-temporal stores, whose lines are joined across rows.
TEST(LabelStates, write_the_same_at_every_stride_and_address_and_nothing_beside) {
  constexpr Index width = 1101, height = 1003;
  constexpr std::int32_t kUnwritten = -9;
  const ByteImage image = noise_image(width, height, 45, 5, 3);
  std::vector<std::int32_t> expected(std::size_t{width * height});
  const LabelView tight(expected.data(), width, height);
  Regions lists;
  for (const LabelOperation& operation : label_operations()) {
    const LabelParameters parameters = {operation.key};
    make_state(operation.variants.front(), width, height, parameters, 1)
        ->run(image.view(), tight, lists);
    for (const auto& variant : operation.variants) {
      if (!unavailable_reason(variant, width).empty()) continue;
      const auto state = make_state(variant, width, height, parameters, 1);
      for (const Index extra : {0, 1, 3, 16, 25}) {
        const auto stride = width + extra;
        std::vector<std::int32_t> found(std::size_t(stride * height + 32), kUnwritten);
        const LabelView view(found.data() + 16 - extra % 16, width, height, stride);
        state->run(image.view(), view, lists);
        std::size_t written = 0;
        for (const std::int32_t label : found) written += label != kUnwritten ? 1 : 0;
        ASSERT_EQ(written, expected.size()) << operation.name << ' ' << isa_name(variant.isa);
        for (Index y = 0; y < height; ++y) {
          ASSERT_TRUE(std::equal(tight.row(y), tight.row(y) + width, view.row(y)))
              << operation.name << ' ' << isa_name(variant.isa) << " row " << y << " + " << extra;
        }
      }
    }
  }
}

}  // namespace
}  // namespace thinbench::detail
