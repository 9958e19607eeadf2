#include "experiments/batches.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/byte_image.hpp"

namespace thinbench {
namespace {

std::uint64_t hash_of(const ConstStackView& stack) {
  std::uint64_t hash = 0xCBF29CE484222325;
  for (Index i = 0; i < stack.count * stack.image_stride; ++i) {
    hash = (hash ^ stack.data[i]) * 0x100000001B3;
  }
  return hash;
}

TEST(StrokeImages, are_the_same_bytes_on_every_machine) {
  EXPECT_EQ(hash_of(stroke_images(100, 28, 1).view()), 285541640250778263U);
  EXPECT_EQ(hash_of(stroke_images(20, 64, 1).view()), 17258440684425848453U);
}

TEST(StrokeImages, differ_and_are_as_dark_as_written_digits) {
  const ImageStack images = stroke_images(200, 28, 1);
  const ConstStackView stack = images.view();
  for (Index i = 1; i < stack.count; ++i) {
    EXPECT_FALSE(equal(stack.image(i - 1), stack.image(i))) << i;
  }
  EXPECT_GT(foreground_share(stack), 0.1);
  EXPECT_LT(foreground_share(stack), 0.3);
}

TEST(StrokeImages, leave_two_pixels_at_the_frame_light) {
  const ImageStack images = stroke_images(200, 28, 2);
  for (Index i = 0; i < 200; ++i) {
    const ConstImageView image = images.view().image(i);
    for (Index y = 0; y < 28; ++y) {
      for (const Index x : {0, 1, 26, 27}) {
        EXPECT_EQ(image.row(y)[x], 0);
        EXPECT_EQ(image.row(x)[y], 0);
      }
    }
  }
}

TEST(StrokeImages, of_no_images_or_no_pixels_are_not_dark) {
  EXPECT_EQ(foreground_share(stroke_images(0, 28, 1).view()), 0);
}

TEST(Batches, have_a_row_for_each_operation_and_size_with_ordered_ratios) {
  const BatchesChoice choice = {40, 4, 1};
  const std::vector<BatchRow> rows = run_batches(choice);
  ASSERT_EQ(rows.size(), 6U);
  for (const BatchRow& row : rows) {
    EXPECT_LE(row.ratio_low, row.ratio);
    EXPECT_LE(row.ratio, row.ratio_high);
    EXPECT_GT(row.single_per_second, 0);
    EXPECT_GT(row.batch_per_second, 0);
    EXPECT_GT(row.iterations, 1);
  }
  const ExperimentReport report = batches_report(rows, choice, " --quick");
  const auto json = nlohmann::json::parse(report.json);
  EXPECT_EQ(json.at("command"), "thinbench experiment batches --quick");
  EXPECT_EQ(json.at("rows").size(), 6U);
  EXPECT_NE(report.markdown.find("| thin_guo_hall | 28 |"), std::string::npos);
}

}  // namespace
}  // namespace thinbench
