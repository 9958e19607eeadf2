// thinbench run on grey images.
#include <regex>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "images/binarise.hpp"
#include "rules/trained_cluster.hpp"
#include "support/made_image.hpp"
#include "support/whole_file.hpp"
#include "thinbench/midpoint_scan.hpp"
#include "training/weights_text.hpp"
#include "typed.hpp"

namespace thinbench {
namespace {

/// Bars of levels 60, 120 and 180 on 0. By Otsu's threshold of 61, those of 120 and 180 are bright.
ByteImage bars() {
  return image_by(90, 40, [](Index x, Index y) {
    return x >= 3 && x < 87 && y >= 4 && y < 36 ? 60 * (x / 15 % 4) : 0;
  });
}

ByteImage bright(int threshold) {
  return mapped(bars(), [=](int level) { return level >= threshold; });
}

class RunCommand : public Commands {
 protected:
  RunCommand() {
    write_grey("in.png", bars().view());
    write_whole_file("weights.json", weights_json(detail::kTrainedCluster, "a test"));
  }
  static ProgramRun run(const std::string& more = "") {
    ProgramRun run = typed("run thin_naccache_shinghal in.png out.png " + more);
    EXPECT_EQ(run.status, 0) << run.err;
    return run;
  }
  static void expect_skeleton(const ByteImage& objects, const Thinning& thinning = {}) {
    expect_image("out.png", thinned(Rule::naccache_shinghal, objects, thinning));
  }
};

TEST_F(RunCommand, writes_the_skeleton_and_prints_one_line) {
  const ProgramRun result = run("--foreground bright --threshold 128");
  EXPECT_EQ(result.err, "");
  const std::regex line(
      R"(thin_naccache_shinghal: 90 x 40, \d+ iterations, \d+ foreground pixels before, )"
      R"(\d+ after, \d+\.\d{3} ms\n)");
  EXPECT_TRUE(std::regex_match(result.out, line)) << result.out;
  expect_skeleton(bright(128));
  EXPECT_EQ(names(), (Names{"in.png", "out.png", "weights.json"}));
}

TEST_F(RunCommand, options_have_the_meaning_of_the_library) {
  struct Case {
    std::string options, out, err;
    ByteImage objects;
    Thinning thinning = {};
  };
  const Case cases[] = {
      {"--threshold 60 --foreground bright", "", "", bright(60)},
      {"--threshold 180 --foreground dark", "", "% of the image is foreground",
       mapped(bars(), [](int level) { return level < 180; })},
      {"", "", "foreground is bright (grey level >= 61)", bright(61)},  // Otsu's threshold
      {"--max-iterations 2", ", 2 iterations, ", "", bright(61), {.max_iterations = 2}},
      {"--border keep", "", "", bright(61), {.border = Border::keep}},
      {"--isa baseline --threads 3", "", "", bright(61)}};
  for (const auto& [options, out, err, objects, thinning] : cases) {
    SCOPED_TRACE(options);
    const ProgramRun result = run(options);
    expect_holds(result.out, out);
    expect_holds(result.err, err);
    expect_skeleton(objects, thinning);
  }
  output_of("run net_single_layer_cluster in.png out.png --weights weights.json");
  expect_skeleton(bright(61));
}

TEST_F(RunCommand, skeleton_is_read_as_foreground) {
  output_of("run thin_guo_hall in.png out.png");
  const ByteImage skeleton = read_grey("out.png");
  EXPECT_EQ(typed("run thin_guo_hall out.png out.png").err, "");
  EXPECT_GT(foreground_pixels(skeleton.view()), 0);
  expect_image("out.png", skeleton);
}

TEST_F(RunCommand, may_overwrite_its_input) {
  output_of("run thin_naccache_shinghal in.png in.png");
  expect_image("in.png", thinned(Rule::naccache_shinghal, bright(61)));
}

TEST_F(RunCommand, directions_select_those_of_the_scan) {
  Directions directions = kNoDirections;
  directions.add(Direction::rows);
  directions.add(Direction::diagonals);
  ByteImage expected = bright(61);
  midpoint_scan(expected.view(), expected.view(), directions);
  output_of("run midpoint_scan in.png out.png --directions rows,diagonals");
  expect_image("out.png", expected);
  output_of("run midpoint_scan in.png out.png --directions columns");
  EXPECT_FALSE(equal(read_grey("out.png").view(), expected.view()));
}

TEST_F(RunCommand, a_file_of_several_pages_is_not_replaced_by_one_page) {
  std::vector<ByteImage> pages;
  for (int i = 0; i < 2; ++i) pages.push_back(bright(61));
  write_grey_pages("in.tif", pages);
  for (const std::string command :
       {"run thin_guo_hall in.tif", "edges in.tif", "fill-holes in.tif", "graph in.tif --out"}) {
    expect_rejected(
        {2, command + " ./in.tif", {"'./in.tif' has 2 pages, of which one would remain"}});
  }
  output_of("run thin_guo_hall in.tif out.tif");
}

TEST_F(RunCommand, rejects_words_with_what_was_given_and_known) {
  const std::string guo_hall = "run thin_guo_hall in.png out.png ";
  const std::string scan = "run midpoint_scan in.png out.png --directions ";
  expect_rejected({
      {2, "run thin_nacache in.png out.png", {"'thin_nacache'", "'thin_naccache_shinghal'?"}},
      {2, guo_hall + "--isa base-line", {"'base-line'", "'baseline'?"}},
      {2, guo_hall + "--isa mmx", {"'mmx'; known: baseline"}},
      {2, guo_hall + "--border keeep", {"'keeep'", "'keep'?"}},
      {2, guo_hall + "--border wrap", {"'wrap'; known: background, keep and foreground"}},
      {2, "run thin_guo_hall in.png a.gif", {"'a.gif'", "'.gif'; known are .png, .pgm, .bmp"}},
      {2, guo_hall + "--directions rows", {"--directions: thin_guo_hall is not a scan"}},
      {2, guo_hall + "--optimise", {"--optimise: thin_guo_hall is built in"}},
      {2, guo_hall + "--weights weights.json", {"--weights: thin_guo_hall is not a net"}},
      {1,
       "run net_two_layer_linear in.png out.png --weights weights.json",
       {"weights.json", "net_two_layer_linear needs two_layer"}},
      {2, scan + "rows,colums", {"'colums'", "'columns'?"}},
      {2, scan + "rows,rows", {"'rows,rows' names rows twice"}},
      {2, "run midpoint_scan in.png out.png --max-iterations 3", {"has no iterations"}},
      {2, "run midpoint_scan in.png out.png --weights weights.json", {"has no weights"}},
      {2, "run midpoint_scan in.png out.pbm", {"midpoint_scan does not take packed files"}},
      {2,
       "run thin_spta in.png out.png",
       {"thin_spta is a part of the study: 'thinbench_benchmarks --pictures DIRECTORY"}},
  });
  for (const std::string list : {"rows,,columns", ",rows", "rows,", ","}) {
    expect_rejected({2, scan + list, {"'" + list + "' has an empty name; known: rows"}});
  }
}

TEST_F(RunCommand, rejects_files_that_cannot_be_read_or_written_with_the_reason) {
  put("text.png", "no picture");
  ASSERT_EQ(mkfifo("pipe", 0666), 0);
  expect_rejected({
      {1, "run thin_guo_hall text.png out.png", {"'text.png'", "not an image of a known format"}},
      {1, "run thin_guo_hall absent.png out.png", {"'absent.png'", "there is no such file"}},
      {1, "run thin_guo_hall in.png absent/a.png", {"'absent/a.png'", "no directory 'absent'"}},
      {1, "run net_two_layer_linear in.png out.png --weights pipe", {"not a regular file"}},
      {1, "run thin_guo_hall pipe raw --raw 8x1", {"not a regular file"}},
  });
}

}  // namespace
}  // namespace thinbench
