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

/// Two lines that touch, with the labels 300 and 7, and a branch of the first.
class GraphLabelsCommand : public testing::Test {
 protected:
  void SetUp() override {
    std::vector<std::uint16_t> labels(12 * 6);
    for (std::size_t x = 1; x < 9; ++x) labels[3 * 12 + x] = 300;
    labels[2 * 12 + 4] = 300;
    for (std::size_t y = 1; y < 5; ++y) labels[y * 12 + 9] = 7;
    write_deep(in, {labels.data(), 12, 6});
  }

  [[nodiscard]] ProgramRun graph(std::vector<std::string> options) const {
    options.insert(options.begin(), {"graph", in, "--labels", "--thinning", "none"});
    return run_with(options);
  }

  TemporaryDirectory directory;
  std::string in = directory.file("labels.png");
  std::string out = directory.file("out.png");
  std::string table = directory.file("table.csv");
};

std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

TEST_F(GraphLabelsCommand, lists_a_graph_for_each_label) {
  const ProgramRun run = graph({});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out,
            "6 nodes (5 ends, 1 junction), 4 edges\n"
            "node 1: end at (9.00, 1.00)\n"
            "node 2: end at (9.00, 4.00)\n"
            "node 3: end at (4.00, 2.00)\n"
            "node 4: end at (1.00, 3.00)\n"
            "node 5: junction at (4.00, 3.00)\n"
            "node 6: end at (8.00, 3.00)\n"
            "edge 1: node 1 to 2, length 3.00, width 2.00 (2.00 to 2.00), label 7\n"
            "edge 2: node 3 to 5, length 1.00, width 2.41 (2.00 to 2.83), label 300\n"
            "edge 3: node 4 to 5, length 3.00, width 2.21 (2.00 to 2.83), label 300\n"
            "edge 4: node 5 to 6, length 4.00, width 2.17 (2.00 to 2.83), label 300\n");
  const Json json = Json::parse(graph({"--json"}).out);
  EXPECT_EQ(json.at("nodes").at(0).at("label"), 7);
  EXPECT_EQ(json.at("edges").at(3).at("label"), 300);
}

TEST_F(GraphLabelsCommand, prunes_each_label_and_writes_labels) {
  ASSERT_EQ(graph({"--prune", "1.5", "--out", out}).status, 0);
  const LabelPixels kept = read_labels(out);
  EXPECT_EQ(kept.view().row(2)[4], 0);
  EXPECT_EQ(kept.view().row(3)[4], 300);
  EXPECT_EQ(kept.view().row(2)[9], 7);
}

TEST_F(GraphLabelsCommand, thins_labels_as_if_each_were_alone) {
  std::vector<std::uint16_t> labels(20 * 9);
  for (std::size_t y = 1; y < 8; ++y) {
    for (std::size_t x = 1; x < 19; ++x) labels[y * 20 + x] = x < 10 ? 1 : 2;
  }
  write_deep(in, {labels.data(), 20, 9});
  ASSERT_EQ(run_with({"graph", in, "--labels", "--csv", table}).status, 0);
  const auto lines = lines_of(table);
  EXPECT_TRUE(lines.front().ends_with(",unit,label"));
  EXPECT_TRUE(lines.at(1).ends_with(",,1"));
  EXPECT_TRUE(lines.back().ends_with(",,2"));
}

TEST_F(GraphLabelsCommand, summary_has_the_columns_of_skan_and_the_label) {
  ASSERT_EQ(graph({"--summary", table, "--spacing", "2,1"}).status, 0);
  EXPECT_EQ(lines_of(table).at(0),
            "skeleton-id,node-id-src,node-id-dst,branch-distance,branch-type,image-coord-src-0,"
            "image-coord-src-1,image-coord-dst-0,image-coord-dst-1,coord-src-0,coord-src-1,"
            "coord-dst-0,coord-dst-1,euclidean-distance,tortuosity,width-mean,width-median,"
            "width-min,width-max,label");
  EXPECT_EQ(lines_of(table).at(1), "0,0,1,6,0,1,9,4,9,2,9,8,9,6,1,2,2,2,2,7");
}

TEST_F(GraphLabelsCommand, widths_are_those_of_the_labels_of_another_image) {
  std::vector<std::uint16_t> labels(12 * 6, 7);
  const std::string objects = directory.file("objects.tif");
  labels[0] = 0;
  write_deep(objects, {labels.data(), 12, 6});
  const Json json = Json::parse(graph({"--json", "--image", objects}).out);
  EXPECT_GT(json.at("edges").at(0).at("width_min"), 18.0);
}

TEST_F(GraphLabelsCommand, what_does_not_fit_is_one_line) {
  const std::string colours = directory.file("colours.ppm");
  std::ofstream(colours) << "P3 1 1 255 1 2 3\n";
  const std::string small = directory.file("small.png");
  write_grey(small, image_of({"..", ".."}).view());
  struct Case {
    std::vector<std::string> options;
    std::string expected;
  };
  for (const auto& [options, expected] : std::vector<Case>{
           {{"--threshold", "5"}, "--labels excludes --threshold 5"},
           {{"--only-thin"}, "--labels excludes --only-thin"},
           {{"--image", small}, "expected 12 x 6 pixels"},
           {{"--image", colours}, "labels are one channel of 8 or 16 bits, and it has 3 of 8"},
           {{"--out", directory.file("a.bmp")}, "BMP holds no 16 bits"},
           {{"--summary", in}, "read or written as another file"},
           {{"--node", "1;2"}, "--node: expected X,Y such as 120,45, got '1;2'"},
           {{"--node", "0,0"}, "expected pixels of the skeleton, got row 0, column 0"},
           {{"--open-cycles", "-1"}, "--open-cycles"}}) {
    const ProgramRun run = graph(options);
    EXPECT_NE(run.status, 0);
    EXPECT_NE(run.err.find(expected), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

TEST_F(GraphLabelsCommand, given_nodes_split_lines_and_cycles_are_opened) {
  write_grey(in, image_of({".......",  //
                           ".#####.",  //
                           ".#...#.",  //
                           ".######"})
                     .view());
  const std::vector<std::string> words = {"graph", in, "--thinning", "none"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), words.begin(), words.end());
    return run_with(more).out;
  };
  EXPECT_EQ(with({"--node", "2,1", "--node", "3,1"}).substr(0, 59),
            "4 nodes (1 end, 1 junction, 2 given), 4 edges\nnode 1: junct");
  EXPECT_EQ(with({"--open-cycles", "5"}).substr(0, 40), with({}).substr(0, 40));
  EXPECT_EQ(with({"--open-cycles", "50"}).substr(0, 36), "2 nodes (1 end, 1 junction), 1 edge\n");
}

}  // namespace
}  // namespace thinbench
