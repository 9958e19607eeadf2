#include <regex>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/made_image.hpp"
#include "thinbench/edges.hpp"
#include "typed.hpp"

namespace thinbench {
namespace {

ByteImage inverted(const ByteImage& image) {
  return mapped(image, [](int level) { return 255 - level; });
}

class EdgesCommand : public Commands {
 protected:
  EdgesCommand() { write_grey("in.png", noise.view()); }

  static void expect_edges(const ByteImage& grey, EdgeOperator op,
                           const EdgeThresholds& thresholds) {
    ByteImage expected(grey.width(), grey.height());
    detect_edges(op, grey.view(), expected.view(), thresholds);
    expect_image("out.png", expected);
  }

  ByteImage noise = grey_noise_image(90, 40, 0, 255, 4);
};

TEST_F(EdgesCommand, writes_the_edges_and_prints_one_line) {
  const ProgramRun run = typed(
      "edges in.png out.png --operator prewitt --p1 70 --p2 200 --foreground dark --threshold 90");
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.status, 0);
  const std::regex line(R"(edges_prewitt: 90 x 40, \d+ edge pixels, \d+\.\d{3} ms\n)");
  EXPECT_TRUE(std::regex_match(run.out, line)) << run.out;
  expect_edges(noise, EdgeOperator::prewitt, {70, 200});
}

TEST_F(EdgesCommand, thresholds_have_long_names_and_defaults_and_bright_foreground_is_inverted) {
  const int gradient = EdgeThresholds{}.gradient_threshold;
  struct Case {
    std::string options;
    EdgeThresholds thresholds;
    bool is_inverted;
  };
  for (const auto& [options, thresholds, is_inverted] : std::vector<Case>{
           {"dark --gradient-threshold 70 --brightness-threshold 200", {70, 200}, false},
           {"dark --threshold 180", {gradient, 179}, false},  // the highest level of foreground
           {"dark --threshold 0", {gradient, 0}, false},
           {"bright --p2 250", {gradient, 250}, true},
           {"bright --threshold 180", {gradient, 255 - 180}, true}}) {
    SCOPED_TRACE(options);
    output_of("edges in.png out.png --foreground " + options);
    expect_edges(
        mapped(noise, [inverts = is_inverted](int level) { return inverts ? 255 - level : level; }),
        EdgeOperator::sobel, thresholds);
  }
}

TEST_F(EdgesCommand, finds_the_same_edges_of_dark_and_bright_foreground_by_default) {
  const ByteImage dark = image_by(
      40, 30, [](Index x, Index y) { return x >= 10 && x < 30 && y >= 8 && y < 20 ? 20 : 100; });
  write_grey("in.png", dark.view());
  expect_holds(typed("edges in.png out.png").err, "foreground is dark");
  const ByteImage edges = read_grey("out.png");
  EXPECT_EQ(edges.at(10, 12), 255);
  EXPECT_EQ(edges.at(15, 12), 0);
  write_grey("in.png", inverted(dark).view());
  expect_holds(typed("edges in.png out.png").err, "foreground is bright");
  expect_image("out.png", edges);
}

TEST_F(EdgesCommand, rejects_invalid_arguments_without_output) {
  const std::string levels = ": expected an integer in [0, 255], got ";
  expect_rejected({
      {2, "edges in.png out.png --operator sobl", {"'sobl'; did you mean 'sobel'?"}},
      {2, "edges in.png out.png --p1 256", {"--gradient-threshold" + levels + "'256'"}},
      {2, "edges in.png out.png --p2 -1", {"--brightness-threshold" + levels + "'-1'"}},
      {2, "edges in.png out.png --isa ''", {"--isa: expected a value, got ''"}},
      {2, "edges in.png a.gif", {"cannot write 'a.gif'"}},
      {1, "edges absent.png out.png", {"cannot read 'absent.png'"}},
  });
}

}  // namespace
}  // namespace thinbench
