#include <regex>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "images/binarise.hpp"
#include "images/image_file.hpp"
#include "program_run.hpp"
#include "rules/trained_cluster.hpp"
#include "support/temporary_directory.hpp"
#include "support/whole_file.hpp"
#include "thinbench/thinning.hpp"
#include "training/weights_text.hpp"

namespace thinbench {
namespace {

constexpr const char* kOperation = "thin_naccache_shinghal";
using Names = std::set<std::string>;

/// Bars of levels 60, 120 and 180 on 0. By Otsu's threshold of 61, those of 120 and 180 are bright.
ByteImage bars(Index width = 90) {
  ByteImage image(width, 40);
  for (Index y = 4; y < 36; ++y) {
    for (Index x = 3; x < width - 3; ++x) {
      image.at(x, y) = static_cast<std::uint8_t>(60 * (x / 15 % 4));
    }
  }
  return image;
}

ByteImage skeleton_of(const ByteImage& grey, int threshold, bool invert) {
  ByteImage image(grey.width(), grey.height());
  for (Index y = 0; y < grey.height(); ++y) {
    for (Index x = 0; x < grey.width(); ++x) {
      image.at(x, y) = (grey.at(x, y) >= threshold) != invert ? 1 : 0;
    }
  }
  thin(Rule::naccache_shinghal, image.view(), image.view());
  return image;
}

class RunCommand : public testing::Test {
 protected:
  void SetUp() override { write_grey(in, bars().view()); }

  ProgramRun run(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"run", kOperation, in, out});
    return run_with(more);
  }
  /// The error message; checks that no file was written.
  [[nodiscard]] std::string failure(std::vector<std::string> more, int status) const {
    more.insert(more.begin(), {"run", kOperation, in, out});
    std::string text = failure_of(more, status);
    EXPECT_EQ(directory.names(), Names{"in.png"});
    return text;
  }
  void expect_output(int threshold, bool invert) const {
    EXPECT_TRUE(equal(read_grey(out).view(), skeleton_of(bars(), threshold, invert).view()));
  }

  TemporaryDirectory directory;
  std::string in = directory.file("in.png");
  std::string out = directory.file("out.png");
};

TEST_F(RunCommand, writes_the_skeleton_and_prints_one_line) {
  const ProgramRun result = run({"--foreground", "bright", "--threshold", "128"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const std::regex line(
      R"(thin_naccache_shinghal: 90 x 40, \d+ iterations, \d+ foreground pixels before, )"
      R"(\d+ after, \d+\.\d{3} ms\n)");
  EXPECT_TRUE(std::regex_match(result.out, line)) << result.out;
  expect_output(128, false);
  EXPECT_EQ(directory.names(), (Names{"in.png", "out.png"}));
}

TEST_F(RunCommand, threshold_and_foreground_select_the_objects) {
  EXPECT_EQ(run({"--threshold", "60", "--foreground", "bright"}).status, 0);
  expect_output(60, false);
  const ProgramRun dark = run({"--threshold", "180", "--foreground", "dark"});
  EXPECT_EQ(dark.status, 0);
  EXPECT_NE(dark.err.find("% of the image is foreground"), std::string::npos) << dark.err;
  expect_output(180, true);
}

TEST_F(RunCommand, uses_otsus_threshold_and_the_likely_foreground_by_default) {
  const ProgramRun result = run();
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "note: " + in +
                            ": foreground is bright (grey level >= 61); --foreground dark and "
                            "--threshold N override this\n");
  expect_output(61, false);
}

TEST_F(RunCommand, skeleton_is_read_as_foreground) {
  ASSERT_EQ(run_with({"run", "thin_guo_hall", in, out}).status, 0);
  const ByteImage skeleton = read_grey(out);
  const ProgramRun again = run_with({"run", "thin_guo_hall", out, out});
  EXPECT_EQ(again.err, "");
  EXPECT_GT(foreground_pixels(skeleton.view()), 0);
  EXPECT_TRUE(equal(read_grey(out).view(), skeleton.view()));
}

TEST_F(RunCommand, max_iterations_limits_the_iterations) {
  const ProgramRun result = run({"--max-iterations", "2"});
  EXPECT_NE(result.out.find(", 2 iterations, "), std::string::npos) << result.out << result.err;
  ByteImage expected(bars().width(), bars().height());
  thin(Rule::naccache_shinghal, binarise(bars(), {}).image.view(), expected.view(),
       {.max_iterations = 2});
  EXPECT_TRUE(equal(read_grey(out).view(), expected.view()));
}

TEST_F(RunCommand, isa_and_threads_do_not_change_the_skeleton) {
  EXPECT_EQ(run({"--isa", "baseline", "--threads", "3"}).status, 0);
  expect_output(61, false);
}

TEST_F(RunCommand, may_overwrite_its_input) {
  EXPECT_EQ(run_with({"run", kOperation, in, in}).status, 0);
  EXPECT_TRUE(equal(read_grey(in).view(), skeleton_of(bars(), 61, false).view()));
  EXPECT_EQ(directory.names(), Names{"in.png"});
}

TEST_F(RunCommand, directions_select_those_of_the_scan) {
  const auto scan = [&](const std::string& names) {
    EXPECT_EQ(run_with({"run", "skeleton_scan", in, out, "--directions", names}).status, 0);
    return read_grey(out);
  };
  Directions directions = kNoDirections;
  directions.add(Direction::rows);
  directions.add(Direction::diagonals);
  ByteImage expected = bars();
  for (Index y = 0; y < expected.height(); ++y) {
    for (Index x = 0; x < expected.width(); ++x) {
      expected.at(x, y) = expected.at(x, y) >= 61 ? 1 : 0;
    }
  }
  thin(Rule(directions), expected.view(), expected.view());
  EXPECT_TRUE(equal(scan("rows,diagonals").view(), expected.view()));
  EXPECT_FALSE(equal(scan("columns").view(), expected.view()));
}

TEST_F(RunCommand, unknown_directions_and_directions_for_other_rules_are_rejected) {
  EXPECT_EQ(failure_of({"run", "skeleton_scan", in, out, "--directions", "rows,colums"}, 2),
            "no direction is named 'colums'; did you mean 'columns'?");
  EXPECT_EQ(failure({"--directions", "rows"}, 2),
            "--directions: thin_naccache_shinghal is not a scan and has no directions");
}

TEST_F(RunCommand, empty_direction_is_rejected_with_the_known_ones) {
  for (const std::string list : {"rows,,columns", ",rows", "rows,", ","}) {
    EXPECT_EQ(failure_of({"run", "skeleton_scan", in, out, "--directions", list}, 2),
              "--directions: '" + list +
                  "' has an empty name; known: rows, columns, "
                  "diagonals and antidiagonals");
  }
  EXPECT_EQ(directory.names(), Names{"in.png"});
}

TEST_F(RunCommand, unknown_operation_is_rejected_with_the_nearest_name) {
  EXPECT_EQ(failure_of({"run", "thin_nacache", in, out}, 2),
            "no rule is named 'thin_nacache'; did you mean 'thin_naccache_shinghal'?");
}

TEST_F(RunCommand, unknown_isa_is_rejected_with_the_nearest_name) {
  EXPECT_EQ(failure({"--isa", "base-line"}, 2),
            "no instruction set is named 'base-line'; did you mean 'baseline'?");
  EXPECT_EQ(failure({"--isa", "mmx"}, 2).find("no instruction set is named 'mmx'; known: baseline"),
            0U);
}

TEST_F(RunCommand, isa_that_is_not_available_is_rejected_with_the_reason) {
  const IsaCap cap("baseline");
  for (const Isa isa : all_isas()) {
    if (isa == Isa::baseline) continue;
    const std::string text = failure({"--isa", std::string(isa_name(isa))}, 1);
    const std::string reason = cpu_supports(isa) ? "above the ISA cap" : "this machine lacks ";
    EXPECT_NE(text.find(reason), std::string::npos) << text;
  }
}

TEST_F(RunCommand, unreadable_input_is_rejected_without_output) {
  const std::string text = directory.with("in.png", "no picture");
  EXPECT_EQ(failure({}, 1), "cannot read '" + in + "': it is not an image of a known format");
  std::filesystem::remove(in);
  EXPECT_EQ(failure_of({"run", kOperation, in, out}, 1),
            "cannot read '" + in + "': there is no such file");
  EXPECT_EQ(directory.names(), Names{});
}

TEST_F(RunCommand, unwritable_output_is_rejected) {
  const std::string absent = directory.file("absent");
  EXPECT_EQ(failure_of({"run", kOperation, in, absent + "/a.png"}, 1),
            "cannot write '" + absent + "/a.png': there is no directory '" + absent + "'");
  EXPECT_EQ(failure_of({"run", kOperation, in, directory.file("a.gif")}, 2),
            "cannot write '" + directory.file("a.gif") +
                "': unknown extension '.gif'; known are .png, .pgm, "
                ".bmp, .tif and .tiff");
  EXPECT_EQ(directory.names(), Names{"in.png"});
}

TEST_F(RunCommand, weights_from_a_file_make_the_net) {
  write_whole_file(directory.file("w.json"), weights_json(detail::kTrainedCluster, "a test"));
  const ProgramRun result =
      run_with({"run", "net_single_layer_cluster", in, out, "--weights", directory.file("w.json")});
  EXPECT_EQ(result.status, 0) << result.err;
  expect_output(61, false);
}

TEST_F(RunCommand, weights_are_read_from_regular_files_alone) {
  const std::string pipe = directory.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0666), 0);
  const auto failure_with = [&](const std::string& weights) {
    return failure_of({"run", "net_two_layer_linear", in, out, "--weights", weights}, 1);
  };
  EXPECT_EQ(failure_with(pipe), "cannot read '" + pipe + "': it is not a regular file");
  EXPECT_EQ(failure_with("/dev/zero"), "cannot read '/dev/zero': it is not a regular file");
  const std::string name = directory.path().string();
  EXPECT_EQ(failure_with(name), "cannot read '" + name + "': it is a directory");
  EXPECT_EQ(failure_of({"run", kOperation, pipe, out, "--raw", "8x1", "--out-of-core"}, 1),
            "cannot read '" + pipe + "': it is not a regular file");
}

TEST_F(RunCommand, weights_of_another_kind_of_net_or_for_other_rules_are_rejected) {
  const std::string weights = directory.file("weights.json");
  write_whole_file(weights, weights_json(detail::kTrainedCluster, "a test"));
  EXPECT_EQ(failure_of({"run", "net_two_layer_linear", in, out, "--weights", weights}, 1),
            weights + ": holds the wrong kind of weights; net_two_layer_linear needs two_layer");
  EXPECT_EQ(failure_of({"run", kOperation, in, out, "--weights", weights}, 2),
            "--weights: thin_naccache_shinghal is not a net and has no weights");
}

}  // namespace
}  // namespace thinbench
