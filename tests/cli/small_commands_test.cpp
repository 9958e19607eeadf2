#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "image/thread_team.hpp"
#include "peers/peers.hpp"
#include "picture/picture.hpp"
#include "program_run.hpp"
#include "support/temporary_folder.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

std::size_t catalogue_size() {
  std::size_t rows = 0;
  for (const Operation& operation : operations_with_peers()) rows += operation.variants.size();
  return rows;
}

TEST(ListCommand, prints_an_aligned_line_for_every_row) {
  const ProgramRun run = run_with({"list"});
  EXPECT_EQ(run.status, 0);
  std::istringstream lines(run.out);
  std::string header;
  std::getline(lines, header);
  const std::size_t column = header.find("available");
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line) && !line.empty(); ++rows) {
    const std::string cell = line.substr(column);
    EXPECT_TRUE(cell == "yes" || cell.rfind("no: ", 0) == 0) << line;
  }
  EXPECT_EQ(rows, catalogue_size());
}

TEST(ListCommand, json_says_why_a_row_is_not_available) {
  const IsaCap cap("baseline");
  const ProgramRun run = run_with({"list", "--json"});
  EXPECT_EQ(run.status, 0);
  const Json list = Json::parse(run.out);
  EXPECT_EQ(list.size(), catalogue_size());
  for (const Json& row : list) {
    EXPECT_EQ(row.size(), 9U);
    EXPECT_LE(row["least_pixels"], row["threads"] == "n" ? kMinPixelsForThreads : 0);
    EXPECT_EQ(row["available"], row["isa"] == "baseline" || row["peer"]);
    EXPECT_EQ(row["available"], row["reason"] == "");
    EXPECT_TRUE(row["threads"] == "1" || row["threads"] == "n");
    EXPECT_NE(row["operation"], "");
    EXPECT_NE(row["technique"], "");
    EXPECT_NE(row["description"], "");
  }
}

TEST(SceneCommand, writes_the_scene_and_says_what_it_shows) {
  const TemporaryFolder folder;
  const std::string file = folder.file("scene.png");
  const ProgramRun run = run_with({"scene", file, "--scale", "2", "--noise", "0"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(std::regex_match(run.out.substr(file.size()),
                               std::regex(R"(: 1020 x 824, \d+ parts, \d+ holes\n)")))
      << run.out;
  EXPECT_EQ(read_grey(file).width(), 1020);
}

TEST(SceneCommand, binary_picture_holds_0_and_255_only) {
  const TemporaryFolder folder;
  const std::string file = folder.file("scene.pgm");
  ASSERT_EQ(run_with({"scene", file, "--binary", "--frame-touching"}).status, 0);
  const ByteImage image = read_grey(file);
  std::set<int> levels;
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) levels.insert(image.at(x, y));
  }
  EXPECT_EQ(levels, (std::set<int>{0, 255}));
}

TEST(SceneCommand, every_option_changes_the_picture) {
  const TemporaryFolder folder;
  std::set<std::string> pictures;
  const std::vector<std::vector<std::string>> options = {
      {}, {"--noise", "0.5"}, {"--seed", "7"}, {"--no-illumination"}, {"--frame-touching"}};
  for (std::vector<std::string> args : options) {
    args.insert(args.begin(), {"scene", folder.file("a.pgm")});
    ASSERT_EQ(run_with(args).status, 0);
    pictures.insert(bytes_of(folder.file("a.pgm")));
  }
  EXPECT_EQ(pictures.size(), options.size());
}

TEST(SceneCommand, truth_needs_no_picture) {
  const ProgramRun run = run_with({"scene", "--truth"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(Json::parse(run.out)["width"], 510);
}

TEST(SceneCommand, truth_and_picture_come_together) {
  const TemporaryFolder folder;
  const ProgramRun run = run_with({"scene", folder.file("a.png"), "--truth"});
  EXPECT_FALSE(Json::parse(run.out)["parts"].empty());
  EXPECT_EQ(folder.names(), std::set<std::string>{"a.png"});
}

TEST(SceneCommand, refuses_what_it_cannot_draw) {
  const std::string see = "; see 'thinbench scene --help'";
  EXPECT_EQ(failure_of({"scene"}, 2), "scene needs OUT, a picture to write, or --truth");
  EXPECT_EQ(failure_of({"scene", "a.png", "--scale", "0"}, 2),
            "--scale: '0' is no whole number from 1 to 100" + see);
  EXPECT_EQ(failure_of({"scene", "a.png", "--noise", "nan"}, 2),
            "--noise: 'nan' is no number from 0 to 255" + see);
  EXPECT_EQ(failure_of({"scene", "a.png", "--seed", "-5"}, 2),
            "--seed: '-5' is no whole number from 0 to 18446744073709551615" + see);
  EXPECT_EQ(failure_of({"scene", "a.xyz"}, 1).find("cannot write 'a.xyz'"), 0U);
}

TEST(MachineCommand, prints_json_with_commit_and_options) {
  const ProgramRun run =
      run_with({"machine", "--commit", "abc", "--options", R"({"quick": true})"});
  EXPECT_EQ(run.status, 0);
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["commit"], "abc");
  EXPECT_EQ(json["options"]["quick"], true);
  EXPECT_EQ(run_with({"machine", "--fingerprint"}).out,
            json["fingerprint"].get<std::string>() + "\n");
}

TEST(MachineCommand, refuses_options_that_are_no_object) {
  for (const std::string text : {"{", "[1]", "quick"}) {
    EXPECT_EQ(failure_of({"machine", "--options", text}, 2),
              "--options: '" + text + R"(' is no JSON object, such as {"quick": true})");
  }
}

}  // namespace
}  // namespace thinbench
