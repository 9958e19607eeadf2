// The reference against examples worked by hand and figures that come from the paper alone.
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

TEST(ReferenceNaccacheShinghal, thin_line_stays) {
  int iterations = 0;
  const TextImage line = {".....", ".###.", "....."};
  EXPECT_EQ(thinned(line, iterations), line);
  EXPECT_EQ(iterations, 1) << "one iteration that flags nothing";
}

TEST(ReferenceNaccacheShinghal, bar_of_three_rows_becomes_its_middle_row) {
  int iterations = 0;
  const TextImage result =
      thinned({".........", ".#######.", ".#######.", ".#######.", "........."}, iterations);
  EXPECT_EQ(result[2], "..#####..") << "the whole contour goes in one iteration";
  EXPECT_EQ(result[1], ".........");
  EXPECT_EQ(result[3], ".........");
}

TEST(ReferenceNaccacheShinghal, line_two_pixels_wide_loses_both_rows_at_once) {
  int iterations = 0;
  const TextImage result = thinned({"........", "########", "########", "........"}, iterations);
  EXPECT_EQ(result[1].substr(2, 4), "....");
  EXPECT_EQ(result[2].substr(2, 4), "....");
}

TEST(ReferenceNaccacheShinghal, outside_is_background_so_shapes_on_the_border_erode) {
  int iterations = 0;
  const TextImage result = thinned({"####", "####", "####"}, iterations);
  EXPECT_EQ(result[0], "....");
  EXPECT_GT(iterations, 1);
}

TEST(ReferenceNaccacheShinghal, single_pixel_stays) {
  int iterations = 0;
  EXPECT_EQ(thinned({"#"}, iterations), TextImage{"#"});
}

}  // namespace
}  // namespace thinbench
