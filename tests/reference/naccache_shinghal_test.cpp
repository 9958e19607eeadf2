// The reference against examples worked by hand and figures that come from the paper alone.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/byte_image.hpp"
#include "reference.hpp"

namespace thinbench {
namespace {

using Picture = std::vector<std::string>;

ByteImage image_of(const Picture& rows) {
  ByteImage image(static_cast<Index>(rows.front().size()), static_cast<Index>(rows.size()));
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      const char pixel = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      image.at(x, y) = pixel == '#' ? 255 : 0;
    }
  }
  return image;
}

Picture thinned(const Picture& rows, int& scans) {
  const ByteImage source = image_of(rows);
  ByteImage skeleton(source.width(), source.height());
  scans = reference::thin_naccache_shinghal(source.view(), skeleton.view());
  Picture result = rows;
  for (Index y = 0; y < source.height(); ++y) {
    for (Index x = 0; x < source.width(); ++x) {
      result[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] =
          skeleton.at(x, y) == 255 ? '#' : '.';
    }
  }
  return result;
}

TEST(ReferenceNaccacheShinghal, thin_line_stays) {
  int scans = 0;
  const Picture line = {".....", ".###.", "....."};
  EXPECT_EQ(thinned(line, scans), line);
  EXPECT_EQ(scans, 1) << "one scan that flags nothing";
}

TEST(ReferenceNaccacheShinghal, bar_of_three_rows_becomes_its_middle_row) {
  int scans = 0;
  const Picture result =
      thinned({".........", ".#######.", ".#######.", ".#######.", "........."}, scans);
  EXPECT_EQ(result[2], "..#####..") << "the whole contour goes in one scan";
  EXPECT_EQ(result[1], ".........");
  EXPECT_EQ(result[3], ".........");
}

TEST(ReferenceNaccacheShinghal, line_two_pixels_wide_loses_both_rows_at_once) {
  int scans = 0;
  const Picture result = thinned({"........", "########", "########", "........"}, scans);
  EXPECT_EQ(result[1].substr(2, 4), "....");
  EXPECT_EQ(result[2].substr(2, 4), "....");
}

TEST(ReferenceNaccacheShinghal, outside_is_light_so_shapes_on_the_frame_erode) {
  int scans = 0;
  const Picture result = thinned({"####", "####", "####"}, scans);
  EXPECT_EQ(result[0], "....");
  EXPECT_GT(scans, 1);
}

TEST(ReferenceNaccacheShinghal, single_pixel_stays) {
  int scans = 0;
  EXPECT_EQ(thinned({"#"}, scans), Picture{"#"});
}

}  // namespace
}  // namespace thinbench
