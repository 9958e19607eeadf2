#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

using Names = std::set<std::string>;

/// Two bright plates on black; the first has a hole of 4 x 3 pixels at (8, 7).
ByteImage plates() {
  ByteImage image(60, 30);
  for (Index y = 2; y < 20; ++y) {
    for (Index x = 3; x < 40; ++x) image.at(x, y) = x < 20 || x > 25 ? 200 : 0;
  }
  for (Index y = 7; y < 10; ++y) {
    for (Index x = 8; x < 12; ++x) image.at(x, y) = 20;
  }
  return image;
}

class HolesCommand : public testing::Test {
 protected:
  void SetUp() override { write_grey(in, plates().view()); }

  TemporaryDirectory directory;
  std::string in = directory.file("in.png");
  std::string overlay = directory.file("overlay.png");
};

TEST_F(HolesCommand, prints_each_object_with_its_holes_as_json) {
  const ProgramRun run = run_with({"holes", in, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const nlohmann::json found = nlohmann::json::parse(run.out);
  EXPECT_EQ(found.at("foreground"), "bright");
  EXPECT_EQ(found.at("threshold"), 21) << "the level that separates the hole from the plates";
  EXPECT_EQ(found.at("threshold_method"), "otsu");
  EXPECT_EQ(found.at("min_area"), 1);
  const nlohmann::json& objects = found.at("objects");
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].at("id"), 1);
  EXPECT_EQ(objects[0].at("area"), 17 * 18 - 12);
  EXPECT_EQ(objects[0].at("box"), (std::vector<int>{3, 2, 17, 18}));
  ASSERT_EQ(objects[0].at("holes").size(), 1U);
  const nlohmann::json& hole = objects[0].at("holes")[0];
  EXPECT_EQ(hole.at("area"), 12);
  EXPECT_EQ(hole.at("centre"), (std::vector<double>{9.5, 8.0}));
  EXPECT_EQ(hole.at("box"), (std::vector<int>{8, 7, 4, 3}));
  EXPECT_EQ(objects[1].at("holes"), nlohmann::json::array());
}

TEST_F(HolesCommand, lists_the_same_for_people) {
  const ProgramRun run = run_with({"holes", in});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("2 objects, 1 hole\n"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("  hole 1: area 12, centre (9.50, 8.00), box 8 7 4 3\n"),
            std::string::npos)
      << run.out;
}

TEST_F(HolesCommand, threshold_and_foreground_choose_the_objects) {
  EXPECT_NE(run_with({"holes", in, "--threshold", "10"}).out.find("2 objects, 0 holes"),
            std::string::npos);
  const ProgramRun dark = run_with({"holes", in, "--foreground", "dark", "--threshold", "100"});
  EXPECT_NE(dark.out.find("2 objects, 2 holes"), std::string::npos);
  EXPECT_EQ(dark.err, "warning: " + in +
                          ": 69.7 % of the image is foreground; --foreground bright takes the "
                          "rest instead\n");
  const ProgramRun json =
      run_with({"holes", in, "--foreground", "dark", "--threshold", "100", "--json"});
  const nlohmann::json found = nlohmann::json::parse(json.out);
  EXPECT_EQ(found.at("foreground"), "dark");
  EXPECT_EQ(found.at("threshold"), 100);
  EXPECT_EQ(found.at("threshold_method"), "given");
}

TEST_F(HolesCommand, finds_parts_of_either_polarity_without_options) {
  const ProgramRun bright = run_with({"holes", in});
  EXPECT_EQ(bright.err, "note: " + in +
                            ": foreground is bright (grey level >= 21); --foreground dark and "
                            "--threshold N override this\n");
  ByteImage inverted = plates();
  for (Index y = 0; y < inverted.height(); ++y) {
    for (Index x = 0; x < inverted.width(); ++x) inverted.at(x, y) = 250 - inverted.at(x, y);
  }
  write_grey(in, inverted.view());
  const ProgramRun dark = run_with({"holes", in});
  EXPECT_EQ(dark.out, bright.out);
  EXPECT_NE(dark.err.find("foreground is dark (grey level < 51)"), std::string::npos) << dark.err;
  EXPECT_EQ(dark.status, 0);
}

TEST_F(HolesCommand, min_area_leaves_out_small_objects_and_holes_everywhere) {
  ByteImage image = plates();
  image.at(50, 1) = 200;                                      // the first object
  image.at(37, 5) = image.at(38, 5) = image.at(14, 15) = 20;  // holes before and after the large
  write_grey(in, image.view());
  EXPECT_NE(run_with({"holes", in}).out.find("3 objects, 3 holes\n"), std::string::npos);
  const ProgramRun list = run_with({"holes", in, "--min-area", "12", "--overlay", overlay});
  EXPECT_NE(list.out.find("2 objects, 1 hole\nobject 1: area 293"), std::string::npos) << list.out;
  EXPECT_NE(list.out.find("  hole 1: area 12, "), std::string::npos) << list.out;
  const ByteImage drawn = read_grey(overlay);
  EXPECT_EQ(drawn.at(50, 1), 200) << "no outline of what was left out";
  EXPECT_EQ(drawn.at(37, 4), 200);
  EXPECT_NE(drawn.at(8, 6), 200) << "the outline of the hole that is large enough";
  const ProgramRun json = run_with({"holes", in, "--min-area", "12", "--json"});
  const nlohmann::json found = nlohmann::json::parse(json.out);
  EXPECT_EQ(found.at("min_area"), 12);
  EXPECT_EQ(found.at("objects").size(), 2U);
  EXPECT_EQ(found.at("/objects/0/id"_json_pointer), 1);
  EXPECT_EQ(found.at("/objects/0/holes"_json_pointer).size(), 1U);
  EXPECT_EQ(found.at("/objects/0/holes/0/id"_json_pointer), 1);
  EXPECT_EQ(found.at("/objects/1/holes"_json_pointer).size(), 0U);
}

TEST_F(HolesCommand, isa_and_threads_do_not_change_the_list) {
  const std::string expected = run_with({"holes", in, "--json"}).out;
  EXPECT_EQ(run_with({"holes", in, "--json", "--isa", "baseline"}).out, expected);
  EXPECT_EQ(run_with({"holes", in, "--json", "--threads", "3"}).out, expected);
}

TEST_F(HolesCommand, image_without_objects_gives_an_empty_list) {
  write_grey(in, ByteImage(20, 10).view());
  const ProgramRun run = run_with({"holes", in, "--json", "--overlay", overlay});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(nlohmann::json::parse(run.out).at("objects"), nlohmann::json::array());
  EXPECT_EQ(run_with({"holes", in}).out, "0 objects, 0 holes\n");
  EXPECT_EQ(run_with({"holes", in}).err,
            "warning: " + in + ": all pixels have the same grey level, 0: none is foreground\n");
  EXPECT_EQ(read_grey(overlay).width(), 20);
}

TEST_F(HolesCommand, overlay_changes_pixels_at_outlines_and_centres_only_round_objects) {
  ASSERT_EQ(run_with({"holes", in, "--overlay", overlay}).status, 0);
  const ByteImage before = plates();
  const ByteImage after = read_grey(overlay);
  ASSERT_EQ(after.width(), before.width());
  EXPECT_NE(after.at(3, 10), before.at(3, 10)) << "outline of the first plate";
  EXPECT_NE(after.at(32, 10), before.at(32, 10)) << "centre of the second plate";
  EXPECT_EQ(after.at(55, 25), before.at(55, 25));
}

TEST_F(HolesCommand, bad_input_gives_one_line_and_no_file) {
  const std::string nowhere = directory.file("nothing.png");
  EXPECT_NE(failure_of({"holes", nowhere, "--overlay", overlay}, 1).find("nothing.png"),
            std::string::npos);
  EXPECT_NE(failure_of({"holes", in, "--overlay", directory.file("a.jpg")}, 1).find("JPEG"),
            std::string::npos);
  EXPECT_NE(failure_of({"holes", in, "--overlay", directory.file("a.pgm")}, 1).find("no colours"),
            std::string::npos);
  EXPECT_NE(
      failure_of({"holes", in, "--overlay", directory.file("no/a.png")}, 1).find("no directory"),
      std::string::npos);
  EXPECT_NE(failure_of({"holes", in, "--threshold", "300"}, 2).find("300"), std::string::npos);
  EXPECT_EQ(failure_of({"holes", in, "--min-area", "0"}, 2),
            "--min-area: expected an integer in [1, 2147483648], got '0'; see 'thinbench holes "
            "--help'");
  EXPECT_EQ(directory.names(), Names{"in.png"});
}

TEST_F(HolesCommand, truncated_jpeg_is_read_with_a_warning_if_lenient) {
  const std::string bytes = bytes_of(THINBENCH_SOURCE_DIR "/results/pictures/scene.jpg");
  const std::string cut = directory.with("cut.jpg", bytes.substr(0, bytes.size() / 2));
  EXPECT_EQ(failure_of({"holes", cut}, 1), "cannot read '" + cut + "': the file is truncated");
  const ProgramRun lenient = run_with({"holes", cut, "--lenient"});
  EXPECT_EQ(lenient.status, 0);
  EXPECT_EQ(lenient.err.rfind("warning: " + cut + ": the file is truncated\n", 0), 0U);
  EXPECT_NE(lenient.out.find("object 1"), std::string::npos);
  const std::string out = directory.file("out");
  const std::vector<std::string> batch = {"batch", "holes", cut, "--out", out};
  EXPECT_EQ(run_with(batch).status, 1);
  std::vector<std::string> with_option = batch;
  with_option.emplace_back("--lenient");
  EXPECT_EQ(run_with(with_option).status, 0);
  EXPECT_NE(bytes_of(out + "/manifest.csv").find("the file is truncated"), std::string::npos);
}

TEST_F(HolesCommand, empty_values_are_rejected) {
  for (const char* option : {"--overlay", "--isa"}) {
    EXPECT_EQ(failure_of({"holes", in, option, ""}, 2),
              std::string(option) + ": expected a value, got ''; see 'thinbench holes --help'");
  }
}

TEST_F(HolesCommand, isas_above_the_cap_are_explained) {
  const IsaCap cap("baseline");
  if (!cpu_supports(Isa::avx2)) GTEST_SKIP() << "needs avx2";
  const std::string text = failure_of({"holes", in, "--isa", "avx2"}, 1);
  EXPECT_NE(text.find("above the ISA cap"), std::string::npos) << text;
}

}  // namespace
}  // namespace thinbench
