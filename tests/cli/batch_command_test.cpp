#include <algorithm>
#include <iostream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "batch/manifest_text.hpp"
#include "batch_fixture.hpp"
#include "images/binarise.hpp"

namespace thinbench {
namespace {

TEST_F(BatchCommand, writes_a_skeleton_for_each_image_and_a_line_in_the_manifest) {
  const ProgramRun ran = batch("thin_guo_hall in --threads 3");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(ran.out.rfind("thin_guo_hall: 3 images done, 0 failed, 0 done before; ", 0), 0U);
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "60.png", "manifest.csv"}));
  for (const Index size : {40, 50, 60}) expect_skeleton(std::to_string(size) + ".png", size);
  const Index pixels = foreground_pixels(thinned(Rule::guo_hall, bar(40)).view());
  expect_holds(without_seconds(manifest()),
               manifest_head({}) + "in/40.png,1,40.png,thin_guo_hall,60,50,bright,1,11,999," +
                   std::to_string(pixels) + ",1,1,s,,\n");
}

TEST_F(BatchCommand, options_of_run_have_the_same_meaning) {
  const std::string options =
      "--foreground dark --threshold 100 --border keep --max-iterations 2 --isa baseline";
  output_of("run thin_guo_hall in/40.png one.png " + options);
  done("thin_guo_hall in " + options);
  expect_image("out/40.png", read_grey("one.png"));
  expect_holds(manifest(),
               ",thin_guo_hall --border keep --max-iterations 2 --foreground dark "
               "--threshold 100,");
}

TEST_F(BatchCommand, directory_of_results_among_the_inputs_is_skipped) {
  done("thin_guo_hall in");
  EXPECT_EQ(batch("thin_guo_hall in out --resume").err,
            "note: skipped 'out', the directory of the results\n");
  expect_holds(done("thin_guo_hall [io]* --resume"), " 3 done before");
}

TEST_F(BatchCommand, finds_inputs_in_directories_patterns_and_files) {
  write_bar("in/deep/70.pgm", 70);
  put("in/notes.txt", "text");
  put("in/._40.png", "hidden");
  EXPECT_EQ(batch("thin_guo_hall in").err,
            "note: skipped 2 files, hidden or without the extension of an image format\n"
            "note: skipped 1 directory; --recursive searches all but links and --out\n");
  EXPECT_FALSE(fs::exists("out/deep"));
  fs::remove_all("out");
  done("thin_guo_hall in --recursive");
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "60.png", "deep/70.png", "manifest.csv"}));
  fs::remove_all("out");
  done("thin_guo_hall in/[45]0.png in/deep/70.pgm in/40.png");
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "70.png", "manifest.csv"}));
  fs::remove_all("out");
  fs::create_directory("colours");
  put("colours/a.ppm", "P3 2 1 255 0 0 0 255 255 255\n");
  done("thin_guo_hall colours");
  EXPECT_EQ(results(), (Names{"a.png", "manifest.csv"}));
}

ProgramRun thin_list(const std::string& list, const std::string& words) {
  std::istringstream stream(list);
  std::streambuf* const before = std::cin.rdbuf(stream.rdbuf());
  const ProgramRun run = batch("thin_guo_hall " + words);
  std::cin.rdbuf(before);
  std::cin.clear();
  return run;
}

TEST_F(BatchCommand, reads_a_list_of_inputs_from_standard_input) {
  write_bar("in/a\n*.png", 70);
  EXPECT_EQ(thin_list("in/40.png\nin/50.png\n", "-").status, 0);
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "manifest.csv"}));
  EXPECT_EQ(thin_list(std::string("in/a\n*.png") + '\0' + "in/60.png", "- --null").status, 0);
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "60.png", "a\n*.png", "manifest.csv"}));
}

TEST_F(BatchCommand, a_list_of_lines_with_nul_characters_is_rejected) {
  const ProgramRun run = thin_list(std::string("in/40.png") + '\0' + "in/50.png\n", "-");
  EXPECT_EQ(run.status, 1);
  expect_holds(run.err, "the list has NUL characters; expected a path on each line, or --null");
  EXPECT_FALSE(fs::exists("out"));
}

TEST_F(BatchCommand, results_inside_the_inputs_are_not_inputs_of_the_next_run) {
  const std::string again = "batch thin_guo_hall in --recursive --out in/out";
  output_of(again);
  expect_begins(output_of(again), "thin_guo_hall: 3 images done");
}

TEST_F(BatchCommand, pages_of_a_tiff_file_become_files_or_one_file) {
  write_pages("pages.tif", {40, 50});
  done("thin_guo_hall pages.tif");
  EXPECT_EQ(results(), (Names{"pages_page1.png", "pages_page2.png", "manifest.csv"}));
  expect_skeleton("pages_page1.png", 40);
  expect_skeleton("pages_page2.png", 50);
  expect_holds(manifest(), "pages.tif,2,pages_page2.png,");
  done("thin_guo_hall pages.tif --format tiff");
  EXPECT_EQ(pages_in(read_file("out/pages.tif")).size(), 2);
  for (const int page : {0, 1}) {
    EXPECT_TRUE(equal(read_grey("out/pages.tif", page).view(),
                      thinned(Rule::guo_hall, bar(40 + 10 * page)).view()));
  }
  expect_holds(done("thin_guo_hall pages.tif --format tiff --resume"),
               "thin_guo_hall: 0 images done, 0 failed, 1 done before");
}

TEST_F(BatchCommand, edges_holes_graphs_and_overlays_equal_those_of_the_commands) {
  output_of("edges in/40.png edges.pgm --operator prewitt --p1 20");
  done("edges_prewitt in --p1 20 --format pgm");
  EXPECT_EQ(bytes_of("out/40.pgm"), bytes_of("edges.pgm"));
  done("thin_guo_hall in/40.png --format pbm");
  expect_skeleton("40.pbm", 40);
  for (const std::string operation : {"graph --prune 3 --tolerance 0.5", "holes --min-area 2",
                                      "localise --gradient-threshold 20"}) {
    for (const std::string kind : {"svg", "png"}) {
      fs::remove_all("out");
      done(operation + " in --overlay " + kind);
      EXPECT_EQ(results().size(), 7U);
      expect_holds(manifest(), "," + operation + " --overlay " + kind + ",60,50,");
      const std::string one = output_of(operation + " in/40.png --json --overlay one." + kind);
      EXPECT_EQ(bytes_of("out/40.json"), one);
      EXPECT_EQ(bytes_of("out/40." + kind), bytes_of("one." + kind));
    }
  }
}

TEST_F(BatchCommand, the_table_has_the_rows_of_all_images) {
  for (const std::string command : {"holes", "localise", "graph"}) {
    std::string joined;
    for (const std::string name : {"40", "50", "60"}) {
      output_of(command + " in/" + name + ".png --csv one.csv");
      const std::string table = bytes_of("one.csv");
      joined += joined.empty() ? table : table.substr(table.find('\n') + 1);
    }
    done(command + " in --table all.csv");
    EXPECT_EQ(bytes_of("all.csv"), joined);
  }
}

TEST_F(BatchCommand, a_table_of_lines_has_the_json_of_each_image) {
  done("graph in --table all.jsonl");
  std::istringstream text(bytes_of("all.jsonl"));
  for (const std::string name : {"40", "50", "60"}) {
    std::string line;
    ASSERT_TRUE(std::getline(text, line));
    EXPECT_EQ(nlohmann::json::parse(line),
              nlohmann::json::parse(bytes_of("out/" + name + ".json")));
  }
}

TEST_F(BatchCommand, rows_of_pages_have_their_numbers) {
  write_pages("pages.tif", {40, 50});
  done("holes pages.tif --table out/all.csv");  // in the directory of the results
  expect_holds(bytes_of("out/all.csv"), "pages.tif,1,60,50,object,1,");
  expect_holds(bytes_of("out/all.csv"), "pages.tif,2,70,50,object,1,");
}

TEST_F(BatchCommand, shards_share_the_inputs_and_each_has_its_own_table_and_manifest) {
  done("holes in --shard 1/2");
  EXPECT_EQ(results(), (Names{"40.json", "60.json", "manifest_1_of_2.csv"}));
  done("holes in --table all.csv --shard 2/2");
  EXPECT_EQ(results(),
            (Names{"40.json", "50.json", "60.json", "manifest_1_of_2.csv", "manifest_2_of_2.csv"}));
  EXPECT_FALSE(fs::exists("all.csv"));
  const std::string text = bytes_of("all_2_of_2.csv");
  EXPECT_EQ(std::ranges::count(text, '\n'), 3) << text;
  expect_holds(text, "/50.png,1,");
  done("holes in --shard 9/9 --manifest mine.jsonl");
  EXPECT_FALSE(fs::exists("mine.jsonl"));
  EXPECT_TRUE(fs::exists("mine_9_of_9.jsonl"));
}

TEST_F(BatchCommand, images_that_differ_in_their_extension_keep_it) {
  write_bar("in/test1.png", 30);
  write_bar("in/test1.bmp", 20);
  done("thin_guo_hall in");
  EXPECT_EQ(read_grey("out/test1.png.png").width(), 50);
  EXPECT_EQ(read_grey("out/test1.bmp.png").width(), 40);
  EXPECT_TRUE(fs::exists("out/40.png"));
}

TEST_F(BatchCommand, two_inputs_with_one_output_fail_alone) {
  write_bar("other/40.png", 20);
  write_bar("other/70.png", 50);
  expect_rejected({1, "batch thin_guo_hall in other --out out --on-error stop", {"'"}});
  const ProgramRun made = batch("thin_guo_hall in other");
  EXPECT_EQ(made.status, 1);
  expect_holds(made.err, "would become '40.png', as does 'in/40.png'");
  EXPECT_EQ(read_grey("out/40.png").width(), 60);
  EXPECT_TRUE(fs::exists("out/70.png"));
}

}  // namespace
}  // namespace thinbench
