#include <regex>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/temporary_directory.hpp"
#include "thinbench/edges.hpp"

namespace thinbench {
namespace {

using Names = std::set<std::string>;

ByteImage grey_image() {
  return grey_noise_image(90, 40, 0, 255, 4);
}

class EdgesCommand : public testing::Test {
 protected:
  void SetUp() override { write_grey(in, grey_image().view()); }

  [[nodiscard]] ProgramRun run(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"edges", in, out});
    return run_with(more);
  }
  /// The error message; checks that no file was written.
  [[nodiscard]] std::string failure(std::vector<std::string> more, int status) const {
    more.insert(more.begin(), {"edges", in, out});
    std::string text = failure_of(more, status);
    EXPECT_EQ(directory.names(), Names{"in.png"});
    return text;
  }
  void expect_output(const ByteImage& grey, EdgeOperator op,
                     const EdgeThresholds& thresholds) const {
    ByteImage expected(grey.width(), grey.height());
    detect_edges(op, grey.view(), expected.view(), thresholds);
    EXPECT_TRUE(equal(read_grey(out).view(), expected.view()));
  }

  TemporaryDirectory directory;
  std::string in = directory.file("in.png");
  std::string out = directory.file("out.png");
};

TEST_F(EdgesCommand, writes_the_edges_and_prints_one_line) {
  const ProgramRun result = run({"--operator", "prewitt", "--p1", "70", "--p2", "200",
                                 "--foreground", "dark", "--threshold", "90"});
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.status, 0) << result.err;
  const std::regex line(R"(edges_prewitt: 90 x 40, \d+ edge pixels, \d+\.\d{3} ms\n)");
  EXPECT_TRUE(std::regex_match(result.out, line)) << result.out;
  expect_output(grey_image(), EdgeOperator::prewitt, {70, 200});
}

TEST_F(EdgesCommand, thresholds_have_long_names) {
  EXPECT_EQ(
      run({"--gradient-threshold", "70", "--brightness-threshold", "200", "--foreground", "dark"})
          .status,
      0);
  expect_output(grey_image(), EdgeOperator::sobel, {70, 200});
}

TEST_F(EdgesCommand, brightness_threshold_defaults_to_the_highest_level_of_dark_foreground) {
  EXPECT_EQ(run({"--foreground", "dark", "--threshold", "180"}).status, 0);
  expect_output(grey_image(), EdgeOperator::sobel, {EdgeThresholds{}.gradient_threshold, 179});
  EXPECT_EQ(run({"--foreground", "dark", "--threshold", "0"}).status, 0);
  expect_output(grey_image(), EdgeOperator::sobel, {EdgeThresholds{}.gradient_threshold, 0});
}

ByteImage inverted_image() {
  ByteImage inverted = grey_image();
  for (Index y = 0; y < 40; ++y) {
    for (Index x = 0; x < 90; ++x) {
      inverted.at(x, y) = static_cast<std::uint8_t>(255 - inverted.at(x, y));
    }
  }
  return inverted;
}

TEST_F(EdgesCommand, images_with_bright_foreground_are_inverted_first) {
  EXPECT_EQ(run({"--p2", "250", "--foreground", "bright"}).status, 0);
  expect_output(inverted_image(), EdgeOperator::sobel, {EdgeThresholds{}.gradient_threshold, 250});
  EXPECT_EQ(run({"--foreground", "bright", "--threshold", "180"}).status, 0);
  expect_output(inverted_image(), EdgeOperator::sobel,
                {EdgeThresholds{}.gradient_threshold, 255 - 180});
}

/// A rectangle of level `part` on level `ground`, away from the image border.
ByteImage rectangle(std::uint8_t ground, std::uint8_t part) {
  ByteImage image(40, 30);
  for (Index y = 0; y < 30; ++y) {
    for (Index x = 0; x < 40; ++x) {
      image.at(x, y) = x >= 10 && x < 30 && y >= 8 && y < 20 ? part : ground;
    }
  }
  return image;
}

TEST_F(EdgesCommand, finds_the_same_edges_of_dark_and_bright_foreground_by_default) {
  write_grey(in, rectangle(100, 20).view());
  const ProgramRun dark = run();
  EXPECT_EQ(dark.err, "note: " + in +
                          ": foreground is dark (grey level < 21); --foreground bright and "
                          "--threshold N override this\n");
  const ByteImage edges = read_grey(out);
  EXPECT_EQ(edges.at(10, 12), 255);
  EXPECT_EQ(edges.at(15, 12), 0);
  write_grey(in, rectangle(155, 235).view());
  EXPECT_NE(run().err.find("foreground is bright"), std::string::npos);
  EXPECT_TRUE(equal(read_grey(out).view(), edges.view()));
}

TEST_F(EdgesCommand, isa_and_threads_do_not_change_the_edges) {
  ASSERT_EQ(run().status, 0);
  const ByteImage edges = read_grey(out);
  ASSERT_EQ(run({"--isa", "baseline", "--threads", "3"}).status, 0);
  EXPECT_TRUE(equal(read_grey(out).view(), edges.view()));
}

TEST_F(EdgesCommand, rejects_invalid_arguments_without_output) {
  EXPECT_EQ(failure({"--operator", "sobl"}, 2),
            "no operator is named 'sobl'; did you mean 'sobel'?");
  EXPECT_EQ(failure({"--p1", "256"}, 2),
            "--gradient-threshold: expected an integer in [0, 255], got '256'; see 'thinbench "
            "edges --help'");
  EXPECT_EQ(failure({"--p2", "-1"}, 2),
            "--brightness-threshold: expected an integer in [0, 255], got '-1'; see 'thinbench "
            "edges --help'");
  EXPECT_EQ(failure({"--isa", ""}, 2).find("--isa: expected a value, got ''"), 0U);
  EXPECT_EQ(failure_of({"edges", in, directory.file("a.gif")}, 2).find("cannot write '"), 0U);
  EXPECT_EQ(failure_of({"edges", directory.file("absent.png"), out}, 1).find("cannot read '"), 0U);
}

}  // namespace
}  // namespace thinbench
