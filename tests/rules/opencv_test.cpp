// Zhang-Suen and Guo-Hall against OpenCV's ximgproc module, which keeps the border.
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/ximgproc.hpp>

#include "harness/test_images.hpp"
#include "images/mat_of.hpp"
#include "scene/scene.hpp"
#include "support/reference_thinning.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

struct RuleAndType {
  BuiltInRule rule;
  cv::ximgproc::ThinningTypes type;
};

ByteImage by_opencv(const RuleAndType& pair, ByteImage& image) {
  cv::Mat skeleton;
  cv::ximgproc::thinning(mat_of(image.view()), skeleton, pair.type);
  ByteImage result(image.width(), image.height());
  skeleton.copyTo(mat_of(result.view()));
  return result;
}

ByteImage by_library(BuiltInRule rule, const ByteImage& image, Border border) {
  ByteImage result(image.width(), image.height());
  thin(rule, image.view(), result.view(), {.border = border});
  return result;
}

/// The image with background in the outermost rows and columns.
ByteImage with_background_border(const ByteImage& image) {
  ByteImage result(image.width(), image.height());
  for (Index y = 1; y < image.height() - 1; ++y) {
    for (Index x = 1; x < image.width() - 1; ++x) result.at(x, y) = image.at(x, y);
  }
  return result;
}

class AgainstOpenCv : public testing::TestWithParam<RuleAndType> {
 protected:
  /// Compares reference and library, keeping the border; and the library, not keeping it, on the
  /// image with a background border, where both give the same.
  static void expect_equal(ByteImage& image, const std::string& what) {
    const BuiltInRule rule = GetParam().rule;
    const ByteImage expected = by_opencv(GetParam(), image);
    const Thinned by_reference = thinned_by_reference(rule, image, {Border::keep});
    EXPECT_TRUE(equal(by_reference.image.view(), expected.view())) << what << ", reference";
    EXPECT_TRUE(equal(by_library(rule, image, Border::keep).view(), expected.view())) << what;
    ByteImage inner = with_background_border(image);
    EXPECT_TRUE(equal(by_library(rule, inner, Border::background).view(),
                      by_opencv(GetParam(), inner).view()))
        << what << ", background at the border";
  }
};

TEST_P(AgainstOpenCv, equal_on_scenes) {
  for (const SceneKind kind : {SceneKind::parts, SceneKind::border_touching}) {
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
    const ByteImage found = by_library(GetParam().rule, image, Border::keep);
    ASSERT_TRUE(equal(found.view(), expected.view())) << bits;
  }
}

TEST_P(AgainstOpenCv, keeping_the_border_changes_the_result_if_the_scene_touches_it) {
  const Scene scene = render_scene({SceneKind::border_touching});
  const BuiltInRule rule = GetParam().rule;
  EXPECT_FALSE(equal(by_library(rule, scene.binary, Border::background).view(),
                     by_library(rule, scene.binary, Border::keep).view()));
}

INSTANTIATE_TEST_SUITE_P(
    Rules, AgainstOpenCv,
    testing::Values(RuleAndType{Rule::zhang_suen, cv::ximgproc::THINNING_ZHANGSUEN},
                    RuleAndType{Rule::guo_hall, cv::ximgproc::THINNING_GUOHALL}),
    [](const auto& tested) { return std::string(rule_name(tested.param.rule)); });

}  // namespace
}  // namespace thinbench
