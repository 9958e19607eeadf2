// Photographs and drawings with default options.
#include "support/external_images.hpp"

#include <gtest/gtest.h>

#include "program_run.hpp"

namespace thinbench {
namespace {

struct Expected {
  const char* file;
  const char* min_area;
  const char* found;
  const char* foreground;
  bool has_warning;
};

class ExternalImage : public testing::TestWithParam<Expected> {};

TEST_P(ExternalImage, has_the_expected_objects_with_default_foreground_and_threshold) {
  const std::filesystem::path path = external_image_directory() / GetParam().file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "there is no " << path;
  const ProgramRun run = run_with({"holes", path.string(), "--min-area", GetParam().min_area});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out.substr(0, run.out.find('\n')), GetParam().found);
  const std::string note = "note: " + path.string() + ": foreground is " + GetParam().foreground;
  EXPECT_EQ(run.err.find(note), 0U) << run.err;
  EXPECT_EQ(run.err.find("warning: ") != std::string::npos, GetParam().has_warning) << run.err;
}

INSTANTIATE_TEST_SUITE_P(
    Defaults, ExternalImage,
    testing::Values(
        // A plate with seven holes, and six other shapes; some single pixels are holes as well.
        Expected{"pic1.png", "20", "7 objects, 7 holes", "dark", false},
        Expected{"horse.png", "20", "1 object, 0 holes", "dark", false},
        // Six parts on a bright table, surrounded by a dark room.
        Expected{"pca_test1.jpg", "1", "1 object, 6 holes", "bright", false},
        // 24 coins in uneven light: a corner of the background merges with one of them.
        Expected{"coins.png", "50", "24 objects, 3 holes", "bright", true}),
    [](const testing::TestParamInfo<Expected>& one) {
      const std::string file = one.param.file;
      return file.substr(0, file.find('.'));
    });

TEST(ExternalImageOfCoins, has_no_warning_if_the_threshold_is_given) {
  const std::filesystem::path path = external_image_directory() / "coins.png";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "there is no " << path;
  const ProgramRun run = run_with({"holes", path.string(), "--threshold", "140", "--foreground",
                                   "bright", "--min-area", "200"});
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.out.find("24 objects, "), 0U) << "the 24 coins: " << run.out;
}

}  // namespace
}  // namespace thinbench
