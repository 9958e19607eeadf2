// Regions of images: what is drawn of them, and which are kept.
#include "images/regions.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "harness/test_images.hpp"
#include "peers/mat_of.hpp"
#include "support/byte_image.hpp"
#include "support/made_image.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

const cv::Vec3b kGreen(0, 170, 0);
const cv::Vec3b kRed(40, 40, 255);
constexpr std::uint8_t kGrey = 100;

/// What is drawn over an even grey image in which `objects` are looked for.
cv::Mat3b overlay_of(const ByteImage& objects, std::int64_t min_area = 1) {
  const TemporaryDirectory directory;
  const ByteImage grey = filled_image(objects.width(), objects.height(), kGrey);
  const std::string path = directory.file("overlay.png");
  write_overlay(path, grey.view(),
                regions_overlay(objects.view(), find_regions(objects.view()), min_area));
  return cv::imread(path, cv::IMREAD_COLOR);
}

void fill(ByteImage& image, const cv::Rect& area, std::uint8_t level) {
  mat_of(image.view())(area).setTo(level);
}

/// Whether anything was drawn in an area.
bool is_drawn(const cv::Mat3b& overlay, const cv::Rect& area) {
  const cv::Mat3b ground(area.size(), cv::Vec3b(kGrey, kGrey, kGrey));
  return cv::norm(overlay(area), ground, cv::NORM_INF) > 0;
}

/// An object of 40 x 40 pixels at (20, 20) with a hole of 20 x 20 in its middle.
ByteImage ring() {
  ByteImage image(80, 80);
  fill(image, {20, 20, 40, 40}, 255);
  fill(image, {30, 30, 20, 20}, 0);
  return image;
}

TEST(Overlay, outlines_of_objects_are_green_and_those_of_holes_red) {
  const cv::Mat3b overlay = overlay_of(ring());
  for (const cv::Point& at : {cv::Point(20, 25), cv::Point(59, 59), cv::Point(40, 20)}) {
    EXPECT_EQ(overlay(at), kGreen) << at;
  }
  for (const cv::Point& at : {cv::Point(29, 40), cv::Point(50, 45), cv::Point(40, 50)}) {
    EXPECT_EQ(overlay(at), kRed) << at;
  }
}

using Outlines = std::vector<std::vector<std::pair<int, int>>>;

/// Pixels and outlines in any order.
template <class Lines>
Outlines sorted_outlines(const Lines& lines) {
  Outlines outlines;
  for (const auto& line : lines) {
    outlines.emplace_back();
    for (const auto& pixel : line) outlines.back().emplace_back(pixel.x, pixel.y);
    std::ranges::sort(outlines.back());
  }
  std::ranges::sort(outlines);
  return outlines;
}

TEST(Overlay, outlines_are_the_contours_that_opencv_finds) {
  for (const int percent : {10, 40, 60, 90}) {
    for (const Index granularity : {1, 2, 5}) {
      const ByteImage objects = noise_image(61, 43, percent, granularity, 7);
      std::vector<std::vector<cv::Point>> contours;
      cv::findContours(mat_of(objects.view()), contours, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
      std::vector<std::vector<Pixel>> lines;
      for (const OverlayLine& line :
           regions_overlay(objects.view(), find_regions(objects.view())).lines) {
        if (line.is_closed) lines.push_back(line.points);
      }
      EXPECT_EQ(sorted_outlines(lines), sorted_outlines(contours)) << percent << ' ' << granularity;
    }
  }
}

TEST(Overlay, svg_has_the_same_outlines_with_their_corners_alone) {
  const TemporaryDirectory directory;
  const ByteImage objects = ring(), grey = filled_image(80, 80, kGrey);
  const std::string path = directory.file("overlay.svg");
  write_overlay(path, grey.view(), regions_overlay(objects.view(), find_regions(objects.view())));
  const std::string text = bytes_of(path);
  EXPECT_NE(text.find("<polygon points=\"20,20 20,59 59,59 59,20 21,20 \" stroke=\"#00aa00\""),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("stroke=\"#ff2828\""), std::string::npos);
  EXPECT_NE(text.find("<text x=\"20\" y=\"18\" fill=\"#00aa00\">1</text>"), std::string::npos)
      << text;
}

TEST(Overlay, bands_mix_with_the_image_and_discs_cover_it) {
  const TemporaryDirectory directory;
  const ByteImage grey = filled_image(40, 20, kGrey);
  Overlay overlay;
  overlay.lines = {{{{5, 10}, {35, 10}}, {200, 200, 200}, false, 7, 0.5, {}}};
  overlay.discs = {{20, 10, 2, {0, 170, 0}, {}}};
  for (const char* name : {"a.png", "a.bmp", "a.tif"}) {
    write_overlay(directory.file(name), grey.view(), overlay);
    const cv::Mat3b drawn = cv::imread(directory.file(name), cv::IMREAD_COLOR);
    EXPECT_EQ(drawn(12, 8), cv::Vec3b(150, 150, 150));
    EXPECT_EQ(drawn(10, 20), kGreen);
    EXPECT_EQ(drawn(2, 8), cv::Vec3b(kGrey, kGrey, kGrey));
  }
  overlay.is_faded = true;
  write_overlay(directory.file("a.png"), grey.view(), overlay);
  EXPECT_NEAR(cv::imread(directory.file("a.png"))(cv::Rect(8, 2, 1, 1)).data[0], 178, 1);
}

TEST(Overlay, number_of_an_object_is_above_it_and_that_of_a_hole_inside_it) {
  const cv::Mat3b overlay = overlay_of(ring());
  EXPECT_TRUE(is_drawn(overlay, {20, 10, 10, 9})) << "the object's number";
  EXPECT_TRUE(is_drawn(overlay, {43, 30, 7, 8})) << "the hole's number";
  EXPECT_FALSE(is_drawn(overlay, {31, 43, 17, 6})) << "the rest of the hole";
  EXPECT_FALSE(is_drawn(overlay, {0, 62, 80, 18})) << "the background below";
}

TEST(Overlay, objects_inside_holes_are_drawn_even_if_the_hole_is_too_small) {
  ByteImage image(80, 80);
  fill(image, {10, 10, 60, 60}, 255);
  fill(image, {20, 20, 40, 40}, 0);
  fill(image, {21, 21, 38, 38}, 255);
  const cv::Mat3b overlay = overlay_of(image, 200);
  EXPECT_EQ(overlay(40, 21), kGreen) << "the inner object";
  EXPECT_EQ(overlay(10, 40), kGreen) << "the outer object";
  EXPECT_EQ(overlay(40, 19), cv::Vec3b(kGrey, kGrey, kGrey)) << "the hole of 156 pixels";
  EXPECT_EQ(overlay_of(image)(40, 19), kRed);
}

TEST(Overlay, numbers_stay_in_the_image) {
  ByteImage corner(60, 30);
  fill(corner, {48, 0, 12, 30}, 255);
  const cv::Mat3b overlay = overlay_of(corner);
  EXPECT_TRUE(is_drawn(overlay, {49, 1, 10, 9}))
      << "inside the object, because there is no space above";
}

TEST(Overlay, regions_smaller_than_a_digit_have_a_point_instead_of_a_number) {
  ByteImage plate(60, 40);
  fill(plate, {5, 15, 50, 20}, 255);
  plate.at(20, 25) = 0;
  const cv::Mat3b overlay = overlay_of(plate);
  EXPECT_EQ(overlay(25, 20), kRed) << "the hole's centre";
  EXPECT_EQ(overlay(25, 19), kRed) << "its outline";
  EXPECT_FALSE(is_drawn(overlay, {7, 17, 20, 7})) << "nothing beside it";
}

using Positions = std::vector<std::size_t>;

/// By first pixels: a dot of 1 pixel; a plate of 20 x 20 with holes of 4 pixels and of 100 with an
/// island of 9 in it; a ring of 8 pixels round a hole of 1.
ByteImage nested_regions() {
  ByteImage image(60, 40);
  image.at(50, 0) = 255;
  fill(image, {5, 5, 20, 20}, 255);
  fill(image, {7, 6, 2, 2}, 0);
  fill(image, {10, 10, 10, 10}, 0);
  fill(image, {12, 12, 3, 3}, 255);
  fill(image, {40, 30, 3, 3}, 255);
  image.at(41, 31) = 0;
  return image;
}

struct Sizes {
  std::vector<std::int64_t> objects;
  std::vector<std::int64_t> holes;
  std::vector<std::uint32_t> enclosing_objects;
  bool operator==(const Sizes&) const = default;
};

Sizes sizes_of(const Regions& found) {
  Sizes sizes;
  for (const Region& object : found.objects) sizes.objects.push_back(object.area);
  for (const Region& hole : found.holes) {
    sizes.holes.push_back(hole.area);
    sizes.enclosing_objects.push_back(hole.enclosing_object);
  }
  return sizes;
}

Sizes kept_sizes(std::int64_t min_area) {
  const Regions found = find_regions(nested_regions().view());
  return sizes_of(selected(found, kept_regions(found, min_area)));
}

TEST(RegionFilter, area_1_keeps_all_as_they_are) {
  const Regions found = find_regions(nested_regions().view());
  const Regions kept = selected(found, kept_regions(found, 1));
  EXPECT_EQ(kept.objects, found.objects);
  EXPECT_EQ(kept.holes, found.holes);
  EXPECT_EQ(sizes_of(found), (Sizes{{1, 296, 9, 8}, {4, 91, 1}, {2, 2, 4}}));
}

TEST(RegionFilter, min_area_is_inclusive_and_enclosing_objects_are_renumbered) {
  EXPECT_EQ(kept_sizes(2), (Sizes{{296, 9, 8}, {4, 91}, {1, 1}}));
  EXPECT_EQ(kept_sizes(4), kept_sizes(2));
  EXPECT_EQ(kept_sizes(5), (Sizes{{296, 9, 8}, {91}, {1}}));
}

TEST(RegionFilter, holes_go_with_their_object_and_objects_stay_without_their_hole) {
  const Regions found = find_regions(nested_regions().view());
  EXPECT_EQ(kept_regions(found, 9).objects, (Positions{1, 2})) << "the ring has 8 pixels";
  EXPECT_EQ(kept_sizes(92), (Sizes{{296}, {}, {}}));
  EXPECT_EQ(kept_sizes(297), (Sizes{}));
  Regions thin = found;
  thin.objects[1].area = 1;  // smaller than its hole and than the object inside
  EXPECT_EQ(sizes_of(selected(thin, kept_regions(thin, 9))), (Sizes{{9}, {}, {}}));
}

}  // namespace
}  // namespace thinbench
