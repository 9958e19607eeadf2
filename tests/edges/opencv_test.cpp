// The references against OpenCV's filters with kernels written down here: another implementation of
// the same formulae. Pictures of one's own join in by THINBENCH_TEST_IMAGES, a folder.
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "harness/edges_family.hpp"
#include "harness/grey_images.hpp"
#include "picture/mat_of.hpp"
#include "picture/picture.hpp"
#include "scene/scene.hpp"
#include "support/given_pictures.hpp"
#include "thinbench/edges.hpp"

namespace thinbench {
namespace {

constexpr EdgeThresholds kThresholds[] = {{40, 128}, {0, 0}, {1, 254}, {12, 60}, {200, 20}};

struct Kernels {
  cv::Mat gx;
  cv::Mat gy;
  int scale;
};

Kernels kernels_of(const std::string& operation) {
  const auto mat = [](int size, std::initializer_list<float> values) {
    return cv::Mat(std::vector<float>(values), true).reshape(1, size);
  };
  if (operation == "edges_roberts4") {
    return {mat(3, {0, 0, 0, 0, 1, 0, 0, 0, -1}), mat(3, {0, 0, 0, 0, 0, 1, 0, -1, 0}), 2};
  }
  if (operation == "edges_roberts9") {
    return {mat(3, {1, 0, 0, 0, 0, 0, 0, 0, -1}), mat(3, {0, 0, 1, 0, 0, 0, -1, 0, 0}), 2};
  }
  if (operation == "edges_sobel") {
    return {mat(3, {-1, 0, 1, -2, 0, 2, -1, 0, 1}), mat(3, {-1, -2, -1, 0, 0, 0, 1, 2, 1}), 4};
  }
  if (operation == "edges_prewitt") {
    return {mat(3, {-1, 0, 1, -1, 0, 1, -1, 0, 1}), mat(3, {-1, -1, -1, 0, 0, 0, 1, 1, 1}), 3};
  }
  if (operation == "edges_mero_vassy") {
    return {mat(3, {0, 1, 1, -1, 0, 1, -1, -1, 0}), mat(3, {-1, -1, 0, -1, 0, 1, 0, 1, 1}), 4};
  }
  return {
      mat(5, {0, 1, 1, 1, 1, -1, 0, 1, 1, 1, -1, -1, 0, 1, 1, -1, -1, -1, 0, 1, -1, -1, -1, -1, 0}),
      mat(5, {-1, -1, -1, -1, 0, -1, -1, -1, 0, 1, -1, -1, 0, 1, 1, -1, 0, 1, 1, 1, 0, 1, 1, 1, 1}),
      12};
}

cv::Mat filtered(const ByteImage& image, const cv::Mat& kernel) {
  cv::Mat result;
  cv::filter2D(mat_of(image.view()), result, CV_32F, kernel, {-1, -1}, 0, cv::BORDER_REPLICATE);
  return result;
}

ByteImage edges_by_opencv(const std::string& operation, const ByteImage& image,
                          const EdgeThresholds& thresholds) {
  const Kernels kernels = kernels_of(operation);
  const cv::Mat magnitude =
      cv::abs(filtered(image, kernels.gx)) + cv::abs(filtered(image, kernels.gy));
  cv::Mat brightest;
  cv::dilate(mat_of(image.view()), brightest, cv::Mat());
  ByteImage result(image.width(), image.height());
  cv::Mat edges = (magnitude > thresholds.p1 * kernels.scale) & (brightest > thresholds.p2);
  edges.copyTo(mat_of(result.view()));
  return result;
}

class EdgesAgainstOpenCv : public testing::TestWithParam<std::string> {
 protected:
  static void expect_equal(const ByteImage& image, const std::string& what) {
    for (const EdgeThresholds& thresholds : kThresholds) {
      const ConstImageView view = image.view();
      const auto job = edges_reference(GetParam(), thresholds)(view.width, view.height, 1);
      const ByteImage expected = edges_by_opencv(GetParam(), image, thresholds);
      EXPECT_TRUE(equal(outcome_of(*job, view).image.view(), expected.view()))
          << what << ", P1 " << thresholds.p1 << ", P2 " << thresholds.p2;
    }
  }
};

TEST_P(EdgesAgainstOpenCv, equal_on_the_scene) {
  Scene scene = render_scene();
  expect_equal(scene.grey, "scene");
}

TEST_P(EdgesAgainstOpenCv, equal_on_noise_of_odd_sizes) {
  for (const auto& [width, height] :
       {std::pair<Index, Index>{1, 1}, {1, 9}, {9, 1}, {2, 2}, {5, 3}, {67, 31}, {129, 40}}) {
    ByteImage image = grey_noise_image(width, height, 0, 255, 7);
    expect_equal(image, std::to_string(width) + " x " + std::to_string(height));
  }
}

TEST_P(EdgesAgainstOpenCv, equal_on_given_pictures) {
  const std::vector<std::string> paths = given_pictures();
  if (paths.empty()) GTEST_SKIP() << "no pictures in " << folder_of_given_pictures();
  for (const std::string& path : paths) {
    expect_equal(read_grey(path), path);
  }
}

INSTANTIATE_TEST_SUITE_P(All, EdgesAgainstOpenCv,
                         testing::Values("edges_roberts4", "edges_roberts9", "edges_mero_vassy",
                                         "edges_mero_vassy_5x5", "edges_sobel", "edges_prewitt"),
                         [](const auto& tested) { return tested.param; });

TEST(EdgesMeroVassy, in_3x3_pixels_take_the_larger_of_sobels_gradients) {
  const ByteImage image = grey_noise_image(131, 67, 0, 255, 9);
  const Kernels sobel = kernels_of("edges_sobel");
  const cv::Mat gx = cv::abs(filtered(image, sobel.gx));
  const cv::Mat gy = cv::abs(filtered(image, sobel.gy));
  const cv::Mat larger = cv::max(gx, gy);
  for (const int p1 : {20, 60, 120}) {
    ByteImage found(image.width(), image.height());
    detect_edges("edges_mero_vassy", image.view(), found.view(), {p1, 0});
    const cv::Mat expected = larger > p1 * sobel.scale;
    EXPECT_GT(cv::countNonZero(expected), 0) << p1;
    EXPECT_EQ(cv::norm(expected, mat_of(found.view()), cv::NORM_INF), 0) << p1;
  }
}

}  // namespace
}  // namespace thinbench
