// Oracles that share no code with the kernels: Euler's formula and OpenCV.
#include <algorithm>
#include <array>
#include <tuple>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "harness/test_images.hpp"
#include "holes.hpp"
#include "peers/mat_of.hpp"
#include "scene/scene.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

using Summary = std::tuple<std::int64_t, int, int, int, int, double, double>;

std::vector<Summary> summaries(const std::vector<Region>& regions) {
  std::vector<Summary> all;
  all.reserve(regions.size());
  for (const Region& region : regions) {
    all.emplace_back(region.area, region.left, region.top, region.right - region.left + 1,
                     region.bottom - region.top + 1, region.centre_x(), region.centre_y());
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// The image with a margin of one background pixel.
cv::Mat padded(const ByteImage& image) {
  ByteImage copy = copy_of(image.view());
  cv::Mat mat;
  cv::copyMakeBorder(mat_of(copy.view()), mat, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  return mat;
}

/// Regions by cv::connectedComponentsWithStats, without the component that contains `omitted`.
std::vector<Summary> opencv_summaries(const cv::Mat& mat, int connectivity, cv::Point omitted) {
  cv::Mat labels;
  cv::Mat stats;
  cv::Mat centres;
  const int count = cv::connectedComponentsWithStats(mat, labels, stats, centres, connectivity);
  const int skipped = labels.at<int>(omitted);
  std::vector<Summary> all;
  for (int label = 1; label < count; ++label) {
    if (label == skipped) continue;
    all.emplace_back(
        stats.at<int>(label, cv::CC_STAT_AREA), stats.at<int>(label, cv::CC_STAT_LEFT) - 1,
        stats.at<int>(label, cv::CC_STAT_TOP) - 1, stats.at<int>(label, cv::CC_STAT_WIDTH),
        stats.at<int>(label, cv::CC_STAT_HEIGHT), centres.at<double>(label, 0) - 1,
        centres.at<double>(label, 1) - 1);
  }
  std::sort(all.begin(), all.end());
  return all;
}

void expect_near(const std::vector<Summary>& found, const std::vector<Summary>& expected,
                 const std::string& what) {
  ASSERT_EQ(found.size(), expected.size()) << what;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto& [area, left, top, width, height, x, y] = found[i];
    const auto& [area2, left2, top2, width2, height2, x2, y2] = expected[i];
    EXPECT_EQ(std::tie(area, left, top, width, height),
              std::tie(area2, left2, top2, width2, height2))
        << what;
    EXPECT_NEAR(x, x2, 1e-9) << what;
    EXPECT_NEAR(y, y2, 1e-9) << what;
  }
}

void expect_equal_to_opencv(const ByteImage& image, const std::string& what) {
  const Regions found = find_regions(image.view());
  const cv::Mat foreground = padded(image);
  const cv::Point corner(0, 0);
  expect_near(summaries(found.objects), opencv_summaries(foreground, 8, corner),
              what + ", objects");
  expect_near(summaries(found.holes), opencv_summaries(foreground == 0, 4, corner),
              what + ", holes");
}

TEST(HolesOracle, euler_formula_holds_on_all_4x4_images_of_the_reference) {
  for (std::uint64_t bits = 0; bits < 65536; ++bits) {
    const ByteImage image = image_of_bits(4, 4, bits);
    const reference::Regions found = reference::holes(image.view());
    ASSERT_EQ(std::ssize(found.objects) - std::ssize(found.holes), euler_number(image.view()))
        << bits;
  }
}

TEST(HolesOracle, euler_formula_holds_on_noise) {
  for (int percent = 5; percent < 100; percent += 10) {
    const ByteImage image = noise_image(517, 301, percent, 1, 7);
    const Regions found = find_regions(image.view());
    EXPECT_EQ(std::ssize(found.objects) - std::ssize(found.holes), euler_number(image.view()))
        << percent;
  }
}

TEST(HolesOracle, opencv_finds_the_same_objects_and_holes) {
  for (int percent = 10; percent < 100; percent += 10) {
    for (const Index granularity : {1, 3, 8}) {
      expect_equal_to_opencv(
          noise_image(257, 130, percent, granularity, 11),
          std::to_string(percent) + " % in blocks of " + std::to_string(granularity));
    }
  }
  for (const SceneKind kind : {SceneKind::parts, SceneKind::border_touching}) {
    expect_equal_to_opencv(render_scene({.kind = kind}).binary, "scene");
  }
}

// In OpenCV's hierarchy, the parent of a hole's contour is the contour of the enclosing object.
TEST(HolesOracle, opencv_gives_each_hole_the_same_enclosing_object) {
  const ByteImage image = noise_image(200, 150, 60, 4, 5);
  const Regions found = find_regions(image.view());
  std::vector<std::vector<cv::Point>> contours;
  std::vector<cv::Vec4i> hierarchy;
  cv::findContours(padded(image), contours, hierarchy, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  /// The corners of a hole's box and of the box of its object.
  using Boxes = std::array<int, 8>;
  const auto boxes_of = [](const cv::Rect& hole, const cv::Rect& object) {
    return Boxes{hole.x,   hole.y,   hole.width,   hole.height,
                 object.x, object.y, object.width, object.height};
  };
  std::vector<Boxes> expected;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const int parent = hierarchy[i][3];
    if (parent < 0) continue;
    // OpenCV traces a hole's contour on the surrounding foreground.
    const cv::Rect box = cv::boundingRect(contours[i]);
    expected.push_back(
        boxes_of({box.x, box.y, box.width - 2, box.height - 2},
                 cv::boundingRect(contours[static_cast<std::size_t>(parent)]) - cv::Point(1, 1)));
  }
  std::vector<Boxes> actual;
  const auto box_of = [](const Region& region) {
    return cv::Rect(region.left, region.top, region.right - region.left + 1,
                    region.bottom - region.top + 1);
  };
  for (const Region& hole : found.holes) {
    actual.push_back(boxes_of(box_of(hole), box_of(found.objects[hole.enclosing_object - 1])));
  }
  std::sort(actual.begin(), actual.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(actual, expected);
}

}  // namespace
}  // namespace thinbench
