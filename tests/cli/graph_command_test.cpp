#include <algorithm>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/temporary_directory.hpp"
#include "support/text_image.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

/// A horizontal line with a short branch upwards, and a pixel on its own.
const TextImage kLines = {"............",  //
                          ".....#......",  //
                          ".....#......",  //
                          ".##########.",  //
                          "............",  //
                          "............",  //
                          "..........#.",  //
                          "............"};

std::string text_in(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class GraphCommand : public testing::Test {
 protected:
  void SetUp() override { write_grey(in, image_of(kLines).view()); }

  [[nodiscard]] ProgramRun graph(std::vector<std::string> options) const {
    options.insert(options.begin(), {"graph", in, "--thinning", "none"});
    return run_with(options);
  }

  TemporaryDirectory directory;
  std::string in = directory.file("in.png");
  std::string out = directory.file("out.png");
  std::string csv = directory.file("edges.csv");
  std::string geojson = directory.file("graph.json");
  std::string overlay = directory.file("graph.svg");
};

TEST_F(GraphCommand, lists_nodes_and_edges_for_people) {
  const ProgramRun run = graph({});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out,
            "5 nodes (1 isolated, 3 ends, 1 junction), 3 edges\n"
            "node 1: end at (5.00, 1.00)\n"
            "node 2: end at (1.00, 3.00)\n"
            "node 3: junction at (5.00, 3.00)\n"
            "node 4: end at (10.00, 3.00)\n"
            "node 5: isolated at (10.00, 6.00)\n"
            "edge 1: node 1 to 3, length 2.00, width 2.00 (2.00 to 2.00)\n"
            "edge 2: node 2 to 3, length 4.00, width 2.00 (2.00 to 2.00)\n"
            "edge 3: node 3 to 4, length 5.00, width 2.00 (2.00 to 2.00)\n");
}

TEST_F(GraphCommand, prints_the_same_as_json) {
  const ProgramRun run = graph({"--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json found = Json::parse(run.out);
  EXPECT_EQ(found.at("width"), 12);
  EXPECT_EQ(found.at("height"), 8);
  ASSERT_EQ(found.at("nodes").size(), 5U);
  EXPECT_EQ(found.at("nodes")[2],
            Json::parse(R"({"id": 3, "kind": "junction", "degree": 3, "centre": [5, 3]})"));
  ASSERT_EQ(found.at("edges").size(), 3U);
  EXPECT_EQ(found.at("edges")[2].at("points"), Json::parse("[[5, 3], [10, 3]]"));
}

TEST_F(GraphCommand, removes_short_branches) {
  const ProgramRun run = graph({"--prune", "3", "--out", out});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out.substr(0, run.out.find('\n')), "3 nodes (1 isolated, 2 ends), 1 edge");
  TextImage expected = kLines;
  expected[1] = expected[2] = "............";
  EXPECT_EQ(text_of(read_grey(out)), expected);
}

TEST_F(GraphCommand, writes_a_table_with_a_row_for_each_edge) {
  ASSERT_EQ(graph({"--csv", csv}).status, 0);
  const std::string text = text_in(csv);
  EXPECT_EQ(std::ranges::count(text, '\n'), 4);
  EXPECT_NE(text.find(",12,8,3,3,4,junction,end,5,3,10,3,4,5,5,2,2,2,2,,\n"), std::string::npos)
      << text;
}

TEST_F(GraphCommand, writes_geojson_in_the_coordinates_of_the_transform) {
  ASSERT_EQ(graph({"--geojson", geojson, "--transform", "2,0,100,0,-2,50"}).status, 0);
  const Json found = Json::parse(text_in(geojson));
  EXPECT_EQ(found.at("type"), "FeatureCollection");
  const Json& features = found.at("features");
  ASSERT_EQ(features.size(), 8U);
  EXPECT_EQ(features[0].at("geometry"),
            Json::parse(R"({"type": "Point", "coordinates": [111, 47]})"));
  EXPECT_EQ(features[7].at("geometry").at("coordinates"), Json::parse("[[111, 43], [121, 43]]"));
  EXPECT_EQ(features[7].at("properties").at("length"), 5);
}

TEST_F(GraphCommand, lengths_and_widths_are_in_the_unit_of_the_spacing) {
  const ProgramRun run =
      graph({"--spacing", "3,0.5", "--unit", "mm", "--json", "--csv", csv, "--geojson", geojson});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json found = Json::parse(run.out);
  EXPECT_EQ(found.at("spacing"), Json::parse("[3.0, 0.5]"));
  EXPECT_EQ(found.at("edges")[2].at("length"), 2.5);
  EXPECT_NE(text_in(csv).find(",2.5,2.5,3.3333333333333335,3.5,1,5,mm,\n"), std::string::npos)
      << text_in(csv);
  const Json features = Json::parse(text_in(geojson)).at("features");
  EXPECT_EQ(features[7].at("geometry").at("coordinates"),
            Json::parse("[[2.75, 10.5], [5.25, 10.5]]"));
}

TEST_F(GraphCommand, spacings_and_units_that_mean_nothing_are_rejected) {
  for (const char* spacing : {"0", "1,2,3", "1,", "wide", "-1", "nan"}) {
    const ProgramRun run = graph({"--spacing", spacing});
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("--spacing: expected one or two numbers"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find(std::string("got '") + spacing), std::string::npos) << run.err;
  }
}

TEST_F(GraphCommand, lists_the_main_path_of_each_component) {
  const ProgramRun run = graph({"--main-path"});
  EXPECT_NE(run.out.find("main path 1: node "), std::string::npos) << run.out;
  const Json paths = Json::parse(graph({"--main-path", "--json"}).out).at("main_paths");
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_EQ(paths[0].at("nodes").size(), paths[0].at("edges").size() + 1);
  EXPECT_FALSE(Json::parse(graph({"--json"}).out).contains("main_paths"));
}

TEST_F(GraphCommand, draws_every_node_and_edge) {
  ASSERT_EQ(graph({"--overlay", overlay}).status, 0);
  const std::string text = text_in(overlay);
  const auto count = [&](const std::string& word) {
    int found = 0;
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; ++at) ++found;
    return found;
  };
  EXPECT_EQ(count("<polyline "), 3);
  EXPECT_EQ(count("<circle "), 5);
  EXPECT_EQ(count("data:image/png;base64,iVBORw0KGgo"), 1);
}

TEST_F(GraphCommand, thins_the_image_unless_told_otherwise) {
  TextImage bar(9, "............");
  for (int y = 3; y < 6; ++y) bar[static_cast<std::size_t>(y)] = ".##########.";
  write_grey(in, image_of(bar).view());
  EXPECT_EQ(run_with({"graph", in}).out.substr(0, 24), "2 nodes (2 ends), 1 edge");
}

TEST_F(GraphCommand, names_the_blocks_of_an_image_that_is_not_thin) {
  TextImage thick = kLines;
  thick[4] = ".....##.....";
  write_grey(in, image_of(thick).view());
  EXPECT_NE(graph({}).err.find("not thin: 1 block of 2 x 2 pixels, the first at (5, 3)"),
            std::string::npos);
  const ProgramRun run = graph({"--only-thin", "--csv", csv});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_FALSE(std::ifstream(csv).is_open());
}

TEST_F(GraphCommand, rejects_unsuitable_options) {
  const std::vector<std::vector<std::string>> misuses = {{"--transform", "1,2,3"},
                                                         {"--transform", "1,2,3,4,5,nan"},
                                                         {"--transform", "1,2,3,4,5,6,7"},
                                                         {"--overlay", "graph.jpg"},
                                                         {"--prune", "-1"},
                                                         {"--tolerance", "nan"},
                                                         {"--thinning", "thick"},
                                                         {"--out", "skeleton.svg"}};
  for (const std::vector<std::string>& options : misuses) {
    std::vector<std::string> words = {"graph", in};
    words.insert(words.end(), options.begin(), options.end());
    const ProgramRun run = run_with(words);
    EXPECT_EQ(run.status, 2) << options[0] << ' ' << options[1];
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
    EXPECT_NE(run.err.find(options[1]), std::string::npos) << run.err;
  }
}

TEST_F(GraphCommand, rejects_files_that_would_replace_each_other) {
  const std::string same = directory.file("./edges.csv");
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--csv", csv, "--geojson", same}, {"--csv", in}}) {
    const ProgramRun run = graph(options);
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("give each its own"), std::string::npos) << run.err;
  }
  EXPECT_FALSE(std::ifstream(csv).is_open());
  EXPECT_EQ(text_of(read_grey(in)), kLines);
  EXPECT_EQ(graph({"--out", in, "--prune", "3"}).status, 0) << "the skeleton may replace IN";
}

TEST_F(GraphCommand, takes_widths_from_another_image) {
  const std::string image = directory.file("image.png");
  TextImage thick(8, "############");
  thick[0] = thick[7] = "............";
  write_grey(image, image_of(thick).view());
  const ProgramRun run = graph({"--image", image});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("edge 2: node 2 to 3, length 4.00, width 6.00 (6.00 to 6.00)\n"),
            std::string::npos)
      << run.out;
  EXPECT_EQ(graph({"--image", image, "--prune-widths", "0.5"}).out.substr(0, 7), "3 nodes");
  write_grey(image, ByteImage(3, 4).view());
  EXPECT_NE(graph({"--image", image}).err.find("expected 12 x 8 pixels"), std::string::npos);
}

TEST_F(GraphCommand, removes_components_only_with_a_length) {
  EXPECT_EQ(graph({"--remove-components"}).status, 2);
  const ProgramRun run = graph({"--remove-components", "--prune", "2"});
  EXPECT_EQ(run.out.substr(0, run.out.find('\n')), "4 nodes (3 ends, 1 junction), 3 edges");
}

TEST_F(GraphCommand, widths_without_background_are_null_and_empty) {
  ByteImage line(9, 1);
  for (Index x = 0; x < 9; ++x) line.at(x, 0) = 255;
  write_grey(in, line.view());
  const ProgramRun run = graph({"--foreground", "bright", "--json", "--csv", csv});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(Json::parse(run.out).at("edges")[0].at("width_min").is_null()) << run.out;
  EXPECT_NE(text_in(csv).find(",8,8,,,,,,\n"), std::string::npos) << text_in(csv);
}

}  // namespace
}  // namespace thinbench
