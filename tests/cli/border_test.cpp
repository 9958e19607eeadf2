// thinbench run --border.
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/ximgproc.hpp>

#include "images/image_file.hpp"
#include "images/mat_of.hpp"
#include "program_run.hpp"
#include "scene/scene.hpp"
#include "support/temporary_directory.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

class BorderOption : public testing::Test {
 protected:
  void SetUp() override { write_grey(in, image.view()); }

  [[nodiscard]] ByteImage thinned(const std::string& operation, const std::string& border) const {
    const ProgramRun ran = run_with({"run", operation, in, out, "--border", border});
    EXPECT_EQ(ran.status, 0) << ran.err;
    return read_grey(out);
  }
  [[nodiscard]] ByteImage by_opencv(cv::ximgproc::ThinningTypes type) {
    ByteImage result(image.width(), image.height());
    cv::Mat skeleton;
    cv::ximgproc::thinning(mat_of(image.view()), skeleton, type);
    skeleton.copyTo(mat_of(result.view()));
    return result;
  }

  TemporaryDirectory directory;
  ByteImage image = std::move(render_scene({SceneKind::border_touching}).binary);
  std::string in = directory.file("in.png");
  std::string out = directory.file("out.png");
};

TEST_F(BorderOption, keep_equals_opencv_on_an_image_that_touches_its_border) {
  EXPECT_TRUE(equal(thinned("thin_zhang_suen", "keep").view(),
                    by_opencv(cv::ximgproc::THINNING_ZHANGSUEN).view()));
  EXPECT_TRUE(equal(thinned("thin_guo_hall", "keep").view(),
                    by_opencv(cv::ximgproc::THINNING_GUOHALL).view()));
}

TEST_F(BorderOption, background_is_the_default_and_differs_from_keep) {
  const ByteImage background = thinned("thin_zhang_suen", "background");
  ASSERT_EQ(run_with({"run", "thin_zhang_suen", in, out}).status, 0);
  EXPECT_TRUE(equal(read_grey(out).view(), background.view()));
  EXPECT_FALSE(equal(thinned("thin_zhang_suen", "keep").view(), background.view()));
}

TEST_F(BorderOption, keep_applies_to_other_rules) {
  for (const std::string operation : {"thin_spta", "skeleton_scan", "net_two_layer_linear"}) {
    ByteImage expected(image.width(), image.height());
    thin(rule_from_name(operation).value(), image.view(), expected.view(),
         {.border = Border::keep});
    EXPECT_TRUE(equal(thinned(operation, "keep").view(), expected.view())) << operation;
  }
}

TEST_F(BorderOption, unknown_name_is_rejected_with_the_known_ones) {
  EXPECT_EQ(failure_of({"run", "thin_guo_hall", in, out, "--border", "wrap"}, 2),
            "no border is named 'wrap'; known: background, keep and foreground");
}

}  // namespace
}  // namespace thinbench
