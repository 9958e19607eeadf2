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

ByteImage edges_by_opencv(const std::string& operation, ByteImage& image,
                          const EdgeThresholds& thresholds) {
  const Kernels kernels = kernels_of(operation);
  const cv::Mat source = mat_of(image.view());
  const auto filtered = [&](const cv::Mat& kernel) {
    cv::Mat result;
    cv::filter2D(source, result, CV_32F, kernel, {-1, -1}, 0, cv::BORDER_REPLICATE);
    return result;
  };
  const cv::Mat magnitude = cv::abs(filtered(kernels.gx)) + cv::abs(filtered(kernels.gy));
  cv::Mat brightest;
  cv::dilate(source, brightest, cv::Mat());
  ByteImage result(image.width(), image.height());
  cv::Mat edges = (magnitude > thresholds.p1 * kernels.scale) & (brightest > thresholds.p2);
  edges.copyTo(mat_of(result.view()));
  return result;
}

class EdgesAgainstOpenCv : public testing::TestWithParam<std::string> {
 protected:
  static void expect_equal(ByteImage& image, const std::string& what) {
    for (const EdgeThresholds& thresholds : kThresholds) {
      const ConstByteView view = image.view();
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
    ByteImage image = read_grey(path);
    expect_equal(image, path);
  }
}

INSTANTIATE_TEST_SUITE_P(All, EdgesAgainstOpenCv,
                         testing::Values("edges_roberts4", "edges_roberts9", "edges_mero_vassy",
                                         "edges_mero_vassy_5x5", "edges_sobel", "edges_prewitt"),
                         [](const auto& tested) { return tested.param; });

TEST(EdgesSobel, mero_vassy_3x3_takes_the_larger_of_sobels_gradients) {
  // From the paper's successor of the operator: D1 + D2 and D1 - D2 are Sobel's gx and gy.
  const Kernels halves = kernels_of("edges_mero_vassy");
  const Kernels sobel = kernels_of("edges_sobel");
  EXPECT_EQ(cv::norm(halves.gx + halves.gy - sobel.gx, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(halves.gy - halves.gx - sobel.gy, cv::NORM_INF), 0);
}

}  // namespace
}  // namespace thinbench
