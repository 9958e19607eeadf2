// Two operations against OpenCV's ximgproc module, which keeps the border.
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/ximgproc.hpp>

#include "harness/operation.hpp"
#include "harness/test_images.hpp"
#include "picture/mat_of.hpp"
#include "scene/scene.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

struct Pair {
  std::string operation;
  cv::ximgproc::ThinningTypes type;
};

ByteImage by_opencv(const Pair& pair, ByteImage& image) {
  cv::Mat skeleton;
  cv::ximgproc::thinning(mat_of(image.view()), skeleton, pair.type);
  ByteImage result(image.width(), image.height());
  skeleton.copyTo(mat_of(result.view()));
  return result;
}

ByteImage by_library(const std::string& operation, const ByteImage& image,
                     const Options& options = {}) {
  ByteImage result(image.width(), image.height());
  thin(operation, image.view(), result.view(), options);
  return result;
}

/// The same with light outermost rows and columns.
ByteImage without_frame(const ByteImage& image) {
  ByteImage result(image.width(), image.height());
  for (Index y = 1; y < image.height() - 1; ++y) {
    for (Index x = 1; x < image.width() - 1; ++x) result.at(x, y) = image.at(x, y);
  }
  return result;
}

class AgainstOpenCv : public testing::TestWithParam<Pair> {
 protected:
  /// Reference, operation and option, where the border is kept; the plain operation, where the
  /// outermost pixels are light.
  static void expect_equal(ByteImage& image, const std::string& what) {
    const std::string& plain = GetParam().operation;
    const std::string keeping = plain + "_keep_border";
    const ByteImage expected = by_opencv(GetParam(), image);
    const Outcome reference = expected_of(keeping, image.view());
    EXPECT_TRUE(equal(reference.image.view(), expected.view())) << what << ", reference";
    EXPECT_TRUE(equal(by_library(keeping, image).view(), expected.view())) << what;
    Options option;
    option.border = Border::keep;
    EXPECT_TRUE(equal(by_library(plain, image, option).view(), expected.view())) << what;
    ByteImage inner = without_frame(image);
    EXPECT_TRUE(equal(by_library(plain, inner).view(), by_opencv(GetParam(), inner).view()))
        << what << ", light frame";
  }
};

TEST_P(AgainstOpenCv, equal_on_scenes) {
  for (const SceneKind kind : {SceneKind::parts, SceneKind::frame_touching}) {
    Scene scene = render_scene({kind});
    expect_equal(scene.binary, "scene");
  }
}

TEST_P(AgainstOpenCv, equal_on_noise_of_many_sizes) {
  std::uint64_t seed = 90;
  for (const auto& [width, height] : {std::pair<Index, Index>{1, 1},
                                      {1, 2},
                                      {2, 1},
                                      {1, 9},
                                      {9, 1},
                                      {2, 2},
                                      {2, 7},
                                      {7, 2},
                                      {3, 3},
                                      {3, 4},
                                      {4, 3},
                                      {5, 3},
                                      {63, 31},
                                      {64, 33},
                                      {65, 40},
                                      {127, 25},
                                      {129, 63},
                                      {511, 19},
                                      {513, 21},
                                      {600, 30}}) {
    for (const int percent : {20, 50, 80, 95, 100}) {
      for (const Index granularity : {1, 2, 5}) {
        ByteImage image = noise_image(width, height, percent, granularity, ++seed);
        expect_equal(image, std::to_string(width) + " x " + std::to_string(height) + ", " +
                                std::to_string(percent) + " % in blocks of " +
                                std::to_string(granularity));
      }
    }
  }
}

TEST_P(AgainstOpenCv, equal_on_all_four_by_four) {
  for (std::uint64_t bits = 0; bits < 65536; ++bits) {
    ByteImage image = image_of_bits(4, 4, bits);
    const ByteImage expected = by_opencv(GetParam(), image);
    const ByteImage found = by_library(GetParam().operation + "_keep_border", image);
    ASSERT_TRUE(equal(found.view(), expected.view())) << bits;
  }
}

TEST_P(AgainstOpenCv, border_makes_a_difference_on_the_frame_touching_scene) {
  const Scene scene = render_scene({SceneKind::frame_touching});
  const std::string& plain = GetParam().operation;
  EXPECT_FALSE(equal(by_library(plain, scene.binary).view(),
                     by_library(plain + "_keep_border", scene.binary).view()));
}

INSTANTIATE_TEST_SUITE_P(Rules, AgainstOpenCv,
                         testing::Values(Pair{"thin_zhang_suen", cv::ximgproc::THINNING_ZHANGSUEN},
                                         Pair{"thin_guo_hall", cv::ximgproc::THINNING_GUOHALL}),
                         [](const auto& tested) { return tested.param.operation; });

}  // namespace
}  // namespace thinbench
