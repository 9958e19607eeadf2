// thinbench graph, of skeletons and of labels.
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <tiffio.h>

#include "support/made_image.hpp"
#include "typed.hpp"

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

const TextImage kRing = {".#####.",  //
                         ".#...#.",  //
                         ".#...#.",  //
                         ".#####."};

int count_of(const std::string& word, const std::string& text) {
  int found = 0;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; ++at) ++found;
  return found;
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

class GraphCommand : public Commands {
 protected:
  GraphCommand() { write_grey("in.png", image_of(kLines).view()); }

  static std::string graph(const std::string& options) {
    return output_of("graph in.png --thinning none " + options);
  }
};

TEST_F(GraphCommand, lists_nodes_and_edges_for_people) {
  EXPECT_EQ(graph(""),
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
  const Json found = Json::parse(graph("--json"));
  EXPECT_EQ(found.at("width"), 12);
  EXPECT_EQ(found.at("height"), 8);
  ASSERT_EQ(found.at("nodes").size(), 5U);
  EXPECT_EQ(found.at("nodes")[2],
            Json::parse(R"({"id": 3, "kind": "junction", "degree": 3, "centre": [5, 3]})"));
  ASSERT_EQ(found.at("edges").size(), 3U);
  EXPECT_EQ(found.at("edges")[2].at("points"), Json::parse("[[5, 3], [10, 3]]"));
}

TEST_F(GraphCommand, removes_short_branches) {
  EXPECT_EQ(first_line(graph("--prune 3 --out out.png")), "3 nodes (1 isolated, 2 ends), 1 edge");
  TextImage expected = kLines;
  expected[1] = expected[2] = "............";
  EXPECT_EQ(text_of(read_grey("out.png")), expected);
  EXPECT_EQ(first_line(graph("--remove-components --prune 2")),
            "4 nodes (3 ends, 1 junction), 3 edges");
}

TEST_F(GraphCommand, writes_geojson_in_the_coordinates_of_the_transform) {
  graph("--geojson graph.json --transform 2,0,100,0,-2,50");
  const Json found = Json::parse(bytes_of("graph.json"));
  EXPECT_EQ(found.at("type"), "FeatureCollection");
  const Json& features = found.at("features");
  ASSERT_EQ(features.size(), 8U);
  EXPECT_EQ(features[0].at("geometry"),
            Json::parse(R"({"type": "Point", "coordinates": [111, 47]})"));
  EXPECT_EQ(features[7].at("geometry").at("coordinates"), Json::parse("[[111, 43], [121, 43]]"));
  EXPECT_EQ(features[7].at("properties").at("length"), 5);
}

TEST_F(GraphCommand, lengths_and_widths_are_in_the_unit_of_the_spacing) {
  const Json found =
      Json::parse(graph("--spacing 0.5,3 --unit mm --json --csv edges.csv --geojson graph.json"));
  EXPECT_EQ(found.at("spacing"), Json::parse("[0.5, 3.0]"));
  EXPECT_EQ(found.at("edges")[2].at("length"), 2.5);
  expect_holds(bytes_of("edges.csv"), ",2.5,2.5,2.5,3.3333333333333335,3.5,1,5,mm,\n");
  const Json features = Json::parse(bytes_of("graph.json")).at("features");
  EXPECT_EQ(features[7].at("geometry").at("coordinates"),
            Json::parse("[[2.75, 10.5], [5.25, 10.5]]"));
}

TEST_F(GraphCommand, tolerance_is_the_larger_side_of_a_pixel_where_it_is_not_given) {
  const auto lines = [&](const std::string& options) {
    std::string points;
    const Json found = Json::parse(graph("--json " + options));
    for (const Json& edge : found.at("edges")) points += edge.at("points").dump();
    return points;
  };
  write_grey("in.png", image_of(kRing).view());
  const std::string whole = lines("--foreground bright");
  EXPECT_EQ(lines("--foreground bright --tolerance 1"), whole);
  for (const std::string spacing : {"0.001", "1000"})
    EXPECT_EQ(lines("--foreground bright --spacing " + spacing), whole) << spacing;
  EXPECT_NE(lines("--foreground bright --spacing 0.001 --tolerance 1"), whole);
}

TEST_F(GraphCommand, geojson_numbers_its_features_and_has_no_line_of_one_position) {
  write_grey("in.png", image_of({"....", ".#..", "...."}).view());
  graph("--foreground bright --main-path --geojson graph.json");
  const Json features = Json::parse(bytes_of("graph.json")).at("features");
  ASSERT_EQ(features.size(), 2U);
  EXPECT_EQ(features[0].at("id"), 1);
  EXPECT_EQ(features[1].at("id"), 2);
  EXPECT_EQ(features[1].at("geometry"),
            Json::parse(R"({"type": "LineString", "coordinates": [[1.5, 1.5], [1.5, 1.5]]})"));
}

TEST_F(GraphCommand, lists_main_paths_which_begin_or_end_within_edges_of_rings) {
  expect_holds(graph("--main-path"), "main path 1: node 2 to node 4, length 9.00\n");
  EXPECT_EQ(Json::parse(graph("--main-path --json")).at("main_paths").size(), 2U);
  EXPECT_FALSE(Json::parse(graph("--json")).contains("main_paths"));
  write_grey("in.png", image_of(kRing).view());
  expect_holds(graph("--foreground bright --main-path"),
               "main path 1: node 1 to edge 1 at (5, 3), length 7.00\n");
  const Json found = Json::parse(
      graph("--foreground bright --main-path --json --geojson ring.json --overlay ring.svg "
            "--tolerance 0"));
  EXPECT_EQ(found.at("main_paths")[0],
            Json::parse(R"({"id": 1, "from": 1, "to": null, "length": 7, "nodes": [1],
                            "edges": [1], "points": [[1, 0], [5, 0], [5, 3]]})"));
  const Json features = Json::parse(bytes_of("ring.json")).at("features");
  ASSERT_EQ(features.size(), 3U);
  EXPECT_EQ(features[2].at("geometry").at("type"), "LineString");
  EXPECT_EQ(features[2].at("properties"),
            Json::parse(R"({"id": 1, "from": 1, "to": null, "length": 7, "kind": "main_path"})"));
  EXPECT_EQ(count_of("<polyline ", bytes_of("ring.svg")), 2) << "the edge and the path";
}

TEST_F(GraphCommand, smoothed_lengths_are_those_of_the_polylines) {
  write_grey("in.png", image_of({"###......", "...###...", "......###"}).view());
  const Json edge =
      Json::parse(graph("--json --csv edges.csv --summary branches.csv")).at("edges")[0];
  EXPECT_DOUBLE_EQ(edge.at("smoothed_length"), std::hypot(8, 2));
  expect_holds(bytes_of("edges.csv"), ",8.82842712474619,8.246211251235321,8.246211251235321,");
  expect_holds(first_line(bytes_of("branches.csv")), ",tortuosity,smoothed-length,width-mean,");
  expect_holds(bytes_of("branches.csv"), ",8.246211251235321,2,2,2,2\n");
}

TEST_F(GraphCommand, writes_the_ids_of_edges_as_labels) {
  graph("--edge-labels edges.tif");
  const LabelPixels labels = read_labels(read_input("edges.tif"));
  EXPECT_EQ(labels.view().row(1)[5], 1);
  EXPECT_EQ(labels.view().row(3)[1], 2);
  EXPECT_EQ(labels.view().row(3)[5], 0) << "the junction";
  EXPECT_EQ(labels.view().row(3)[6], 3);
  EXPECT_EQ(labels.view().row(6)[10], 0) << "no edge";
  expect_rejected({{2, "graph in.png --edge-labels edges.jpg", {"edges.jpg"}},
                   {2, "graph in.png --csv a.png --edge-labels a.png", {"give each its own"}}});
}

TEST_F(GraphCommand, draws_every_node_and_edge) {
  graph("--overlay graph.svg");
  const std::string text = bytes_of("graph.svg");
  EXPECT_EQ(count_of("<polyline ", text), 3);
  EXPECT_EQ(count_of("<circle ", text), 5);
  EXPECT_EQ(count_of("data:image/png;base64,iVBORw0KGgo", text), 1);
}

TEST_F(GraphCommand, thins_the_image_unless_told_otherwise) {
  TextImage bar(9, "............");
  for (int y = 3; y < 6; ++y) bar[static_cast<std::size_t>(y)] = ".##########.";
  write_grey("in.png", image_of(bar).view());
  EXPECT_EQ(first_line(output_of("graph in.png")), "2 nodes (2 ends), 1 edge");
}

TEST_F(GraphCommand, names_the_blocks_of_an_image_that_is_not_thin) {
  TextImage thick = kLines;
  thick[4] = ".....##.....";
  write_grey("in.png", image_of(thick).view());
  const std::string reason = "not thin: 1 block of 2 x 2 pixels, the first at (5, 3)";
  expect_holds(typed("graph in.png --thinning none").err, reason);
  const ProgramRun run = typed("graph in.png --thinning none --only-thin --csv edges.csv");
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_FALSE(fs::exists("edges.csv"));
}

TEST_F(GraphCommand, takes_widths_from_another_image) {
  write_grey("image.png",
             image_by(12, 8, [](Index, Index y) { return y > 0 && y < 7 ? 255 : 0; }).view());
  expect_holds(graph("--image image.png"),
               "edge 2: node 2 to 3, length 4.00, width 6.00 (6.00 to 6.00)\n");
  EXPECT_EQ(graph("--image image.png --prune-widths 0.5").substr(0, 7), "3 nodes");
}

TEST_F(GraphCommand, widths_without_background_are_null_and_empty) {
  write_grey("in.png", filled_image(9, 1, 255).view());
  const Json found = Json::parse(graph("--foreground bright --json --csv edges.csv"));
  EXPECT_TRUE(found.at("edges")[0].at("width_min").is_null()) << found;
  expect_holds(bytes_of("edges.csv"), ",8,8,8,,,,,,\n");
}

TEST_F(GraphCommand, rejects_options_with_what_was_given) {
  for (const std::string spacing : {"0", "1,2,3", "1,", "wide", "-1", "nan"}) {
    expect_rejected({2,
                     "graph in.png --spacing " + spacing,
                     {"--spacing: expected one or two numbers", "got '" + spacing}});
  }
  for (const std::string options :
       {"--transform 1,2,3 --geojson g", "--transform 1,2,3,4,5,nan --geojson g",
        "--transform 1,2,3,4,5,6,7 --geojson g", "--overlay graph.jpg", "--prune -1",
        "--tolerance nan", "--thinning thick", "--out skeleton.svg"}) {
    expect_rejected({2, "graph in.png " + options, {words_of(options)[1]}});
  }
  const std::string known = "; known are .svg, .png, .bmp, .tif and .tiff";
  expect_rejected({2, "graph in.png --overlay a.pgm", {"PGM holds no colours" + known}});
  write_grey("small.png", ByteImage(3, 4).view());
  expect_rejected({
      {1, "graph in.png --image small.png", {"expected 12 x 8 pixels"}},
      {2, "graph in.png --transform 1,0,0,0,1,0", {"--geojson"}},
      {2, "graph in.png --remove-components", {}},
      {1, "graph in.png --node 0,1", {"in.png: --node 0,1 is not on the skeleton"}},
      {1, "graph in.png --node 12,1", {"in.png: --node 12,1 is not on the skeleton"}},
  });
}

TEST_F(GraphCommand, rejects_files_that_would_replace_each_other) {
  expect_rejected({
      {2, "graph in.png --csv edges.csv --geojson ./edges.csv", {"give each its own"}},
      {2, "graph in.png --csv in.png", {"give each its own"}},
      {2, "graph in.png --image wide.png --csv wide.png", {"give each its own"}},
  });
  EXPECT_EQ(text_of(read_grey("in.png")), kLines);
  EXPECT_EQ(typed("graph in.png --thinning none --out in.png --prune 3").status, 0)
      << "the skeleton may replace IN";
}

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
  const std::string graph = "graph in.png --thinning none ";
  EXPECT_EQ(first_line(output_of(graph + "--node 2,1 --node 3,1")),
            "4 nodes (1 end, 1 junction, 2 given), 4 edges");
  EXPECT_EQ(first_line(output_of(graph + "--open-cycles 5")), first_line(output_of(graph)));
  EXPECT_EQ(first_line(output_of(graph + "--open-cycles 50")),
            "2 nodes (1 end, 1 junction), 1 edge");
}

}  // namespace
}  // namespace thinbench
