// The reference on hand-worked examples.
#include <gtest/gtest.h>

#include "reference.hpp"
#include "support/text_image.hpp"

namespace thinbench {
namespace {

TextImage thinned(const TextImage& lines, int& iterations) {
  ByteImage image = image_of(lines);
  iterations = reference::thinning(Rule::naccache_shinghal)({}, image.view(), image.view());
  return text_of(image);
}

TEST(ReferenceNaccacheShinghal, thin_line_is_kept) {
  int iterations = 0;
  const TextImage line = {".....", ".###.", "....."};
  EXPECT_EQ(thinned(line, iterations), line);
  EXPECT_EQ(iterations, 1) << "one iteration that removes nothing";
}

TEST(ReferenceNaccacheShinghal, bar_of_three_rows_becomes_its_middle_row) {
  int iterations = 0;
  const TextImage result =
      thinned({".........", ".#######.", ".#######.", ".#######.", "........."}, iterations);
  EXPECT_EQ(result[2], "..#####..") << "one iteration removes the whole contour";
  EXPECT_EQ(result[1], ".........");
  EXPECT_EQ(result[3], ".........");
}

TEST(ReferenceNaccacheShinghal, line_two_pixels_wide_loses_both_rows_in_one_iteration) {
  int iterations = 0;
  const TextImage result = thinned({"........", "########", "########", "........"}, iterations);
  EXPECT_EQ(result[1].substr(2, 4), "....");
  EXPECT_EQ(result[2].substr(2, 4), "....");
}

TEST(ReferenceNaccacheShinghal, shape_on_the_image_border_erodes_from_there) {
  int iterations = 0;
  const TextImage result = thinned({"####", "####", "####"}, iterations);
  EXPECT_EQ(result[0], "....");
  EXPECT_GT(iterations, 1);
}

TEST(ReferenceNaccacheShinghal, single_pixel_is_kept) {
  int iterations = 0;
  EXPECT_EQ(thinned({"#"}, iterations), TextImage{"#"});
}

}  // namespace
}  // namespace thinbench
