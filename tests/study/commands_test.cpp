// Commands of thinbench-study that take little: scene, train, experiment, instructions, circuits.
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "images/image_file.hpp"
#include "program_run.hpp"
#include "rules/weights_file.hpp"
#include "support/command_help.hpp"
#include "support/temporary_directory.hpp"
#include "training/weights_text.hpp"

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

TEST(Program, every_help_has_examples) {
  EXPECT_EQ(all_commands(study_program()).size(), 1 + 8 + 2 + 7U);
  expect_every_help_has_examples(study_program());
}

TEST(TrainCommand, two_layer_prints_epochs_and_restarts_and_writes_both_files) {
  const TemporaryDirectory directory;
  const std::string json = directory.file("weights.json");
  const std::string markdown = directory.file("weights.md");
  const ProgramRun ran =
      run_with({"train", "two-layer", "--seed", "2", "--out", json, "--markdown", markdown});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(
      ran.out.find("Correct on 256 of 256 descriptors with the sigmoid and 256 with the linear "
                   "threshold, after 289 epochs and 0 restarts"),
      0U);
  const auto weights = std::get<TwoLayerWeights>(read_weights(json));
  EXPECT_EQ(table_markdown(to_net(weights)), bytes_of(markdown));
  EXPECT_NE(bytes_of(json).find("\"made_by\": \"thinbench-study train two-layer --seed 2\""),
            std::string::npos);
}

TEST(TrainCommand, cluster_writes_weights_and_header_with_their_commands) {
  const TemporaryDirectory directory;
  const std::string json = directory.file("cluster.json");
  const std::string header = directory.file("cluster.hpp");
  const ProgramRun ran =
      run_with({"train", "cluster", "--integer", "--out", json, "--header", header});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out.find("12 nets, correct on all 256 descriptors"), 0U);
  EXPECT_NE(ran.out.find("5 + 52 + 65 = 17 + 37 + 68"), std::string::npos);
  EXPECT_EQ(std::get<ClusterWeights>(read_weights(json)).count, 12);
  EXPECT_NE(
      bytes_of(header).find("thinbench-study train cluster --integer --header " + header + "\n"),
      std::string::npos);
}

TEST(ExperimentCommand, prints_a_table_and_writes_the_data) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("quantisation.json");
  const ProgramRun ran = run_with({"experiment", "quantisation", "--out", file});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("| rounded | 0 | 251 | 252 | 20 |"), std::string::npos);
  EXPECT_EQ(ran.err, "wrote " + file + "\n");
  EXPECT_EQ(Json::parse(bytes_of(file)).at("experiment"), "quantisation");
}

TEST(ExperimentCommand, every_experiment_prints_a_table) {
  for (const char* name : {"cluster-runs", "literal-holes", "quantisation", "operation-counts"}) {
    EXPECT_NE(run_with({"experiment", name}).out.find("| --- |"), std::string::npos) << name;
  }
  const ProgramRun ran = run_with({"experiment", "hidden-neurons", "--quick"});
  EXPECT_NE(ran.out.find("| 12 | 256 |"), std::string::npos) << ran.out;
  EXPECT_NE(ran.err.find("hidden neurons: 91 %"), std::string::npos) << ran.err;
}

TEST(ExperimentCommand, quality_takes_pictures_and_leaves_skeletons) {
  const TemporaryDirectory directory;
  const std::string picture = directory.file("spot.png");
  ByteImage spot(20, 10);
  for (Index x = 4; x < 15; ++x) spot.at(x, 5) = spot.at(x, 6) = spot.at(x, 7) = 255;
  write_grey(picture, spot.view());
  const std::string file = directory.file("quality.json");
  const ProgramRun ran = run_with({"experiment", "quality", "--image", picture, "--pictures-out",
                                   directory.path().string(), "--out", file});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("| thin_guo_hall | background | spot | 1 | 1 | 0 | 0 |"),
            std::string::npos);
  EXPECT_EQ(read_grey(directory.file("quality_spot_thin_guo_hall.png")).width(), 20);
  EXPECT_EQ(Json::parse(bytes_of(file)).at("command"),
            "thinbench-study experiment quality --image spot.png");
  const ProgramRun dark = run_with({"experiment", "quality", "--image", picture, "--foreground",
                                    "dark", "--threshold", "9", "--out", file});
  EXPECT_NE(dark.out.find("| thin_guo_hall | background | spot | 1 | 1 | 1 | 1 |"),
            std::string::npos);
  EXPECT_EQ(dark.err.find("warning: " + picture + ": 83.5 % of the image is foreground"), 0U);
  EXPECT_EQ(Json::parse(bytes_of(file)).at("command"),
            "thinbench-study experiment quality --image spot.png --foreground dark --threshold 9");
}

constexpr const char* kFilter = "^euler_number/bitpacked/baseline/1/";

/// A command that counts two cases.
Words count_command(const Words& more) {
  Words words = {"instructions", "--filter", kFilter};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(InstructionsCommand, image_is_binarised_by_the_given_options) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.png");
  ByteImage image(100, 64);
  for (Index x = 20; x < 80; ++x) image.at(x, 16) = 200;
  write_grey(file, image.view());
  const auto hash_of = [](const ProgramRun& run) {
    return Json::parse(run.out).at("/input/hash"_json_pointer);
  };
  const ProgramRun bright = run_with(count_command({"--json", "--image", file}));
  EXPECT_EQ(bright.err.find("note: " + file + ": foreground is bright"), 0U) << bright.err;
  const ProgramRun dark =
      run_with(count_command({"--json", "--image", file, "--foreground", "dark"}));
  EXPECT_NE(hash_of(dark), hash_of(bright));
}

std::string checked_in() {
  std::ifstream file(THINBENCH_SOURCE_DIR "/kernels/rules/built_in/circuits.hpp");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The circuits of a header, and what stands before and after them.
std::vector<std::string> parts_of(const std::string& header) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from < header.size();) {
    const std::size_t end = std::min(header.find("\n\n", from), header.size());
    parts.push_back(header.substr(from, end - from));
    from = end + 2;
  }
  return parts;
}

void expect_checked_in(const ProgramRun& run, std::size_t circuits) {
  constexpr std::size_t kOtherParts = 6;
  ASSERT_EQ(run.status, 0) << run.err;
  const std::vector<std::string> known = parts_of(checked_in());
  const std::vector<std::string> printed = parts_of(run.out);
  EXPECT_EQ(printed.size(), kOtherParts + circuits);
  for (const std::string& part : printed) {
    EXPECT_NE(std::find(known.begin(), known.end(), part), known.end()) << part;
  }
}

TEST(CircuitsCommand, finds_the_circuits_that_are_checked_in) {
  expect_checked_in(run_with({"circuits", "spta_directional", "naccache_shinghal"}), 4);
}

TEST(CircuitsCommand, keeps_circuits_where_a_search_finds_none_with_fewer_gates) {
  expect_checked_in(
      run_with({"circuits", "spta_directional", "naccache_shinghal", "--effort", "10"}), 4);
}

}  // namespace
}  // namespace thinbench
