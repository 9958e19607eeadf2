#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <tiffio.h>

#include "support/text_image.hpp"
#include "typed.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

/// Two lines that touch, with the labels 300 and 7, and a branch of the first.
class GraphLabelsCommand : public Commands {
 protected:
  GraphLabelsCommand() {
    std::vector<std::uint16_t> labels(12 * 6);
    for (std::size_t x = 1; x < 9; ++x) labels[3 * 12 + x] = 300;
    labels[2 * 12 + 4] = 300;
    for (std::size_t y = 1; y < 5; ++y) labels[y * 12 + 9] = 7;
    write_deep("in.png", {labels.data(), 12, 6});
  }

  static std::string graph(const std::string& options) {
    return output_of("graph in.png --labels --thinning none " + options);
  }
};

std::vector<std::string> lines_of(const std::string& path) {
  std::istringstream text(bytes_of(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

/// One pixel of 8 bits, of which 0 is white.
void write_inverted_tiff(const std::string& path) {
  TIFF* const tiff = TIFFOpen(path.c_str(), "w");
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 1);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 1);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISWHITE);
  std::uint8_t label = 5;
  TIFFWriteScanline(tiff, &label, 0, 0);
  TIFFClose(tiff);
}

/// A BMP file with the short header of OS/2 and one pixel of 8 bits, as its palette has it.
std::string bmp_of_os2(char level) {
  const std::string header("BM\x1e\x03\0\0\0\0\0\0\x1a\x03\0\0\x0c\0\0\0\1\0\1\0\1\0\x08\0", 26);
  std::string palette(768, '\0');
  palette[6] = palette[7] = palette[8] = level;
  return header + palette + std::string("\2\0\0\0", 4);
}

TEST_F(GraphLabelsCommand, reads_bmp_with_a_short_header) {
  put("short.bmp", bmp_of_os2(9));
  expect_holds(output_of("graph short.bmp --labels --json"), R"("label": 9)");
}

TEST_F(GraphLabelsCommand, lists_a_graph_for_each_label) {
  EXPECT_EQ(graph(""),
            "6 nodes (5 ends, 1 junction), 4 edges\n"
            "node 1: end at (9.00, 1.00)\n"
            "node 2: end at (9.00, 4.00)\n"
            "node 3: end at (4.00, 2.00)\n"
            "node 4: end at (1.00, 3.00)\n"
            "node 5: junction at (4.00, 3.00)\n"
            "node 6: end at (8.00, 3.00)\n"
            "edge 1: node 1 to 2, length 3.00, width 2.00 (2.00 to 2.00), label 7\n"
            "edge 2: node 3 to 5, length 1.00, width 2.00 (2.00 to 2.00), label 300\n"
            "edge 3: node 4 to 5, length 3.00, width 2.00 (2.00 to 2.00), label 300\n"
            "edge 4: node 5 to 6, length 4.00, width 2.00 (2.00 to 2.00), label 300\n");
  const Json json = Json::parse(graph("--json"));
  EXPECT_EQ(json.at("nodes").at(0).at("label"), 7);
  EXPECT_EQ(json.at("edges").at(3).at("label"), 300);
}

TEST_F(GraphLabelsCommand, prunes_each_label_and_writes_labels) {
  graph("--prune 1.5 --out out.png");
  const LabelPixels kept = read_labels(read_file("out.png"));
  EXPECT_EQ(kept.view().row(2)[4], 0);
  EXPECT_EQ(kept.view().row(3)[4], 300);
  EXPECT_EQ(kept.view().row(2)[9], 7);
}

TEST_F(GraphLabelsCommand, thins_labels_as_if_each_were_alone) {
  std::vector<std::uint16_t> labels(20 * 9);
  for (std::size_t y = 1; y < 8; ++y) {
    for (std::size_t x = 1; x < 19; ++x) labels[y * 20 + x] = x < 10 ? 1 : 2;
  }
  write_deep("in.png", {labels.data(), 20, 9});
  output_of("graph in.png --labels --csv table.csv");
  const auto lines = lines_of("table.csv");
  EXPECT_TRUE(lines.front().ends_with(",unit,label"));
  EXPECT_TRUE(lines.at(1).ends_with(",,1"));
  EXPECT_TRUE(lines.back().ends_with(",,2"));
}

TEST_F(GraphLabelsCommand, summary_has_the_columns_of_skan_and_the_label) {
  graph("--summary table.csv --spacing 1,2");
  EXPECT_EQ(lines_of("table.csv").at(0),
            "skeleton-id,node-id-src,node-id-dst,branch-distance,branch-type,image-coord-src-0,"
            "image-coord-src-1,image-coord-dst-0,image-coord-dst-1,coord-src-0,coord-src-1,"
            "coord-dst-0,coord-dst-1,euclidean-distance,tortuosity,smoothed-length,width-mean,"
            "width-median,width-min,width-max,label");
  EXPECT_EQ(lines_of("table.csv").at(1), "0,0,1,6,0,1,9,4,9,2,9,8,9,6,1,6,2,2,2,2,7");
}

TEST_F(GraphLabelsCommand, widths_are_those_of_the_labels_of_another_image) {
  std::vector<std::uint16_t> labels(12 * 6, 7);
  labels[0] = 0;
  write_deep("objects.tif", {labels.data(), 12, 6});
  const Json json = Json::parse(graph("--json --image objects.tif"));
  EXPECT_GT(json.at("edges").at(0).at("width_min"), 18.0);
}

TEST_F(GraphLabelsCommand, what_does_not_fit_is_one_line) {
  put("colours.ppm", "P3 1 1 255 1 2 3\n");
  write_grey("small.png", ByteImage(2, 2).view());
  const float real = 0.5F;
  write_reals("real.tif", {&real, 1, 1});
  write_inverted_tiff("inverted.tif");
  const std::string graph = "graph in.png --thinning none --labels ";
  expect_rejected({
      {2, graph + "--threshold 5", {"--labels excludes --threshold"}},
      {2, graph + "--only-thin", {"--labels excludes --only-thin"}},
      {1, graph + "--image small.png", {"expected 12 x 6 pixels"}},
      {1, graph + "--image colours.ppm", {"labels are one channel, and it has 3"}},
      {1, "graph real.tif --labels", {"labels are whole numbers, and it has real ones"}},
      {1, "graph inverted.tif --labels", {"labels need 0 as black, and its 0 is white"}},
      {2, graph + "--out a.bmp", {"BMP holds no 16 bits; known are .png, .pgm, .tif and .tiff"}},
      {2, graph + "--summary in.png", {"read or written as another file"}},
      {2, graph + "--node 1;2", {"--node: expected X,Y such as 120,45, got '1;2'"}},
      {1, graph + "--node 0,0", {"in.png: --node 0,0 is not on the skeleton"}},
      {2, graph + "--open-cycles -1", {"--open-cycles"}},
  });
}

TEST_F(GraphLabelsCommand, given_nodes_split_lines_and_cycles_are_opened) {
  write_grey("in.png", image_of({".......",  //
                                 ".#####.",  //
                                 ".#...#.",  //
                                 ".######"})
                           .view());
  const auto first_line = [](const std::string& options) {
    const std::string text = output_of("graph in.png --thinning none " + options);
    return text.substr(0, text.find('\n'));
  };
  EXPECT_EQ(first_line("--node 2,1 --node 3,1"), "4 nodes (1 end, 1 junction, 2 given), 4 edges");
  EXPECT_EQ(first_line("--open-cycles 5"), first_line(""));
  EXPECT_EQ(first_line("--open-cycles 50"), "2 nodes (1 end, 1 junction), 1 edge");
}

}  // namespace
}  // namespace thinbench
