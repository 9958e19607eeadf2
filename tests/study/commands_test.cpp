// Commands of thinbench-study that take little: scene, train, experiment, instructions, circuits.
#include <algorithm>
#include <regex>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "rules/weights_file.hpp"
#include "training/weights_text.hpp"
#include "typed.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

using Study = Commands;

TEST_F(Study, scene_writes_the_scene_and_says_what_it_shows) {
  const std::string text = output_of("scene scene.png --scale 2 --noise 0");
  EXPECT_TRUE(
      std::regex_match(text, std::regex(R"(scene\.png: 1020 x 824, \d+ parts, \d+ holes\n)")))
      << text;
  EXPECT_EQ(read_grey("scene.png").width(), 1020);
}

TEST_F(Study, scene_that_is_binary_holds_0_and_255_only) {
  output_of("scene scene.pgm --binary --border-touching");
  const ByteImage image = read_grey("scene.pgm");
  std::set<int> levels;
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) levels.insert(image.at(x, y));
  }
  EXPECT_EQ(levels, (std::set<int>{0, 255}));
}

TEST_F(Study, scene_is_another_picture_by_every_option) {
  std::set<std::string> pictures;
  for (const std::string options :
       {"", "--noise 0.5", "--seed 7", "--no-illumination", "--border-touching"}) {
    output_of("scene a.pgm " + options);
    EXPECT_TRUE(pictures.insert(bytes_of("a.pgm")).second) << options;
  }
}

TEST_F(Study, scene_needs_no_picture_for_its_truth) {
  EXPECT_EQ(Json::parse(output_of("scene --truth"))["width"], 510);
}

TEST_F(Study, every_help_has_examples) {
  expect_every_help_has_examples(1 + 8 + 2 + 7);
}

TEST_F(Study, train_two_layer_prints_epochs_and_restarts_and_writes_both_files) {
  expect_begins(
      output_of("train two-layer --seed 2 --out weights.json --markdown weights.md"),
      "Correct on 256 of 256 descriptors with the sigmoid and 256 with the linear threshold, after "
      "289 epochs and 0 restarts");
  const auto weights = std::get<TwoLayerWeights>(read_weights("weights.json"));
  EXPECT_EQ(table_markdown(to_net(weights)), bytes_of("weights.md"));
  expect_holds(bytes_of("weights.json"),
               "\"made_by\": \"thinbench-study train two-layer --seed 2\"");
}

TEST_F(Study, train_cluster_writes_weights_and_header_with_their_commands) {
  const std::string text =
      output_of("train cluster --integer --out cluster.json --header cluster.hpp");
  expect_begins(text, "12 nets, correct on all 256 descriptors");
  expect_holds(text, "5 + 52 + 65 = 17 + 37 + 68");
  EXPECT_EQ(std::get<ClusterWeights>(read_weights("cluster.json")).count, 12);
  expect_holds(bytes_of("cluster.hpp"),
               "thinbench-study train cluster --integer --header cluster.hpp\n");
}

TEST_F(Study, experiment_prints_a_table_and_writes_the_data) {
  const ProgramRun ran = typed("experiment quantisation --out quantisation.json");
  EXPECT_EQ(ran.status, 0) << ran.err;
  expect_holds(ran.out, "| rounded | 0 | 251 | 252 | 20 |");
  EXPECT_EQ(ran.err, "wrote quantisation.json\n");
  EXPECT_EQ(Json::parse(bytes_of("quantisation.json")).at("experiment"), "quantisation");
}

TEST_F(Study, every_experiment_prints_a_table) {
  for (const std::string name :
       {"cluster-runs", "literal-holes", "quantisation", "operation-counts"}) {
    expect_holds(typed("experiment " + name).out, "| --- |");
  }
  const ProgramRun ran = typed("experiment hidden-neurons --quick");
  expect_holds(ran.out, "| 12 | 256 |");
  expect_holds(ran.err, "hidden neurons: 91 %");
}

TEST_F(Study, experiment_of_quality_takes_pictures_and_leaves_skeletons) {
  ByteImage spot(20, 10);
  for (Index x = 4; x < 15; ++x) spot.at(x, 5) = spot.at(x, 6) = spot.at(x, 7) = 255;
  write_grey("spot.png", spot.view());
  const std::string words = "experiment quality --image spot.png --out quality.json ";
  expect_holds(output_of(words + "--pictures-out ."),
               "| thin_guo_hall | background | spot | 1 | 1 | 0 | 0 |");
  EXPECT_EQ(read_grey("quality_spot_thin_guo_hall.png").width(), 20);
  EXPECT_EQ(Json::parse(bytes_of("quality.json")).at("command"),
            "thinbench-study experiment quality --image spot.png");
  const ProgramRun dark = typed(words + "--foreground dark --threshold 9");
  expect_holds(dark.out, "| thin_guo_hall | background | spot | 1 | 1 | 1 | 1 |");
  expect_begins(dark.err, "warning: spot.png: 83.5 % of the image is foreground");
  EXPECT_EQ(Json::parse(bytes_of("quality.json")).at("command"),
            "thinbench-study experiment quality --image spot.png --foreground dark --threshold 9");
}

TEST_F(Study, instructions_of_an_image_are_of_the_given_foreground) {
  ByteImage image(100, 64);
  for (Index x = 20; x < 80; ++x) image.at(x, 16) = 200;
  write_grey("a.png", image.view());
  const std::string words =  // that count two cases
      "instructions --filter ^euler_number/bitpacked/baseline/1/ --json --image a.png ";
  const auto hash_of = [](const ProgramRun& run) {
    return Json::parse(run.out).at("/input/hash"_json_pointer);
  };
  const ProgramRun bright = typed(words);
  expect_begins(bright.err, "note: a.png: foreground is bright");
  EXPECT_NE(hash_of(typed(words + "--foreground dark")), hash_of(bright));
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

void expect_checked_in(const std::string& printed, std::size_t circuits) {
  constexpr std::size_t kOtherParts = 6;
  const std::vector<std::string> known =
      parts_of(bytes_of(THINBENCH_SOURCE_DIR "/kernels/rules/built_in/circuits.hpp"));
  EXPECT_EQ(parts_of(printed).size(), kOtherParts + circuits);
  for (const std::string& part : parts_of(printed)) {
    EXPECT_NE(std::find(known.begin(), known.end(), part), known.end()) << part;
  }
}

TEST_F(Study, circuits_that_are_checked_in_are_found_and_kept_where_a_search_finds_none_smaller) {
  const std::string words = "circuits spta_directional naccache_shinghal ";
  expect_checked_in(output_of(words), 4);
  expect_checked_in(output_of(words + "--effort 10"), 4);
}

}  // namespace
}  // namespace thinbench
