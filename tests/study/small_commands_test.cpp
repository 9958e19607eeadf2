#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

TEST(SceneCommand, writes_the_scene_and_says_what_it_shows) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("scene.png");
  const ProgramRun run = run_with({"scene", file, "--scale", "2", "--noise", "0"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(std::regex_match(run.out.substr(file.size()),
                               std::regex(R"(: 1020 x 824, \d+ parts, \d+ holes\n)")))
      << run.out;
  EXPECT_EQ(read_grey(file).width(), 1020);
}

TEST(SceneCommand, binary_image_holds_0_and_255_only) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("scene.pgm");
  ASSERT_EQ(run_with({"scene", file, "--binary", "--border-touching"}).status, 0);
  const ByteImage image = read_grey(file);
  std::set<int> levels;
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) levels.insert(image.at(x, y));
  }
  EXPECT_EQ(levels, (std::set<int>{0, 255}));
}

TEST(SceneCommand, every_option_changes_the_picture) {
  const TemporaryDirectory directory;
  std::set<std::string> pictures;
  const std::vector<std::vector<std::string>> options = {
      {}, {"--noise", "0.5"}, {"--seed", "7"}, {"--no-illumination"}, {"--border-touching"}};
  for (std::vector<std::string> args : options) {
    args.insert(args.begin(), {"scene", directory.file("a.pgm")});
    ASSERT_EQ(run_with(args).status, 0);
    pictures.insert(bytes_of(directory.file("a.pgm")));
  }
  EXPECT_EQ(pictures.size(), options.size());
}

TEST(SceneCommand, truth_needs_no_picture) {
  EXPECT_EQ(Json::parse(run_with({"scene", "--truth"}).out)["width"], 510);
}

}  // namespace
}  // namespace thinbench
