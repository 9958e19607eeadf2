#include <algorithm>
#include <iostream>
#include <sstream>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "batch/manifest_text.hpp"
#include "batch_fixture.hpp"
#include "images/binarise.hpp"

namespace thinbench {
namespace {

TEST_F(BatchCommand, writes_a_skeleton_for_each_image_and_a_line_in_the_manifest) {
  const ProgramRun ran = run({in, "--threads", "3"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(ran.out.rfind("thin_guo_hall: 3 images done, 0 failed, 0 done before; ", 0), 0U)
      << ran.out;
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "60.png", "manifest.csv"}));
  for (const Index size : {40, 50, 60}) expect_skeleton(std::to_string(size) + ".png", size);
  const ByteImage skeleton = skeleton_of(bar(40));
  const std::string first_line = without_seconds(manifest()).substr(manifest_head({}).size());
  EXPECT_EQ(first_line.substr(0, first_line.find('\n')),
            in + "/40.png,1,40.png,thin_guo_hall,60,50,bright,1,11,999," +
                std::to_string(foreground_pixels(skeleton.view())) + ",1,1,s,,");
}

TEST_F(BatchCommand, options_of_run_have_the_same_meaning) {
  const std::string one = directory.file("one.png");
  const Words options = {"--foreground",     "dark", "--threshold", "100",     "--border", "keep",
                         "--max-iterations", "2",    "--isa",       "baseline"};
  Words run_words = {"run", "thin_guo_hall", in + "/40.png", one};
  run_words.insert(run_words.end(), options.begin(), options.end());
  ASSERT_EQ(run_with(run_words).status, 0);
  Words batch_words = {in};
  batch_words.insert(batch_words.end(), options.begin(), options.end());
  ASSERT_EQ(run(batch_words).status, 0);
  EXPECT_TRUE(equal(read_grey(one).view(), read_grey(result("40.png")).view()));
  EXPECT_NE(manifest().find(",thin_guo_hall --border keep --max-iterations 2 --foreground dark "
                            "--threshold 100,"),
            std::string::npos);
}

TEST_F(BatchCommand, finds_inputs_in_directories_patterns_and_files) {
  write_bar("in/deep/70.pgm", 70);
  static_cast<void>(directory.with("in/notes.txt", "text"));
  static_cast<void>(directory.with("in/._40.png", "hidden"));
  EXPECT_EQ(run({in}).err,
            "note: skipped 2 files, hidden or without the extension of an image format\n"
            "note: skipped 1 directory; --recursive searches all but links and --out\n");
  EXPECT_FALSE(fs::exists(result("deep")));
  fs::remove_all(out);
  EXPECT_EQ(run({in, "--recursive"}).status, 0);
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "60.png", "deep/70.png", "manifest.csv"}));
  fs::remove_all(out);
  EXPECT_EQ(run({in + "/[45]0.png", in + "/deep/70.pgm", in + "/40.png"}).status, 0);
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "70.png", "manifest.csv"}));
}

TEST_F(BatchCommand, reads_a_list_of_inputs_from_standard_input) {
  write_bar("in/a\n*.png", 70);
  const auto run_on_list = [&](const std::string& list, const Words& more) {
    std::istringstream stream(list);
    std::streambuf* const before = std::cin.rdbuf(stream.rdbuf());
    EXPECT_EQ(run(more).status, 0);
    std::cin.rdbuf(before);
    std::cin.clear();
  };
  run_on_list(in + "/40.png\n" + in + "/50.png\n", {"-"});
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "manifest.csv"}));
  run_on_list(in + "/a\n*.png" + '\0' + in + "/60.png", {"-", "--null"});
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "60.png", "a\n*.png", "manifest.csv"}));
}

TEST_F(BatchCommand, results_inside_the_inputs_are_not_inputs_of_the_next_run) {
  const Words again = {"batch", "thin_guo_hall", in, "--recursive", "--out", in + "/out"};
  EXPECT_EQ(run_with(again).status, 0);
  EXPECT_EQ(run_with(again).out.find("3 images done"), std::string("thin_guo_hall: ").size());
}

TEST_F(BatchCommand, pages_of_a_tiff_file_become_files_or_one_file) {
  write_pages("pages.tif", {40, 50});
  EXPECT_EQ(run({directory.file("pages.tif")}).status, 0);
  EXPECT_EQ(results(), (Names{"pages_page1.png", "pages_page2.png", "manifest.csv"}));
  expect_skeleton("pages_page1.png", 40);
  expect_skeleton("pages_page2.png", 50);
  EXPECT_NE(manifest().find("pages.tif,2,pages_page2.png,"), std::string::npos);
  EXPECT_EQ(run({directory.file("pages.tif"), "--format", "tiff"}).status, 0);
  EXPECT_EQ(page_count(result("pages.tif")), 2);
  for (const int page : {0, 1}) {
    EXPECT_TRUE(equal(read_grey_page(result("pages.tif"), page).view(),
                      skeleton_of(bar(40 + 10 * page)).view()));
  }
  EXPECT_EQ(run({directory.file("pages.tif"), "--format", "tiff", "--resume"})
                .out.find("thin_guo_hall: 0 images done, 0 failed, 1 done before"),
            0U);
}

TEST_F(BatchCommand, formats_hold_the_same_pixels) {
  for (const std::string format : {"pgm", "pbm"}) {
    EXPECT_EQ(run({in + "/40.png", "--format", format}).status, 0);
    expect_skeleton("40." + format, 40);
  }
}

TEST_F(BatchCommand, holes_and_edges_equal_their_commands) {
  const std::string file = in + "/40.png";
  ASSERT_EQ(run({in, "--min-area", "2"}, "holes").status, 0);
  EXPECT_EQ(bytes_of(result("40.json")),
            run_with({"holes", file, "--json", "--min-area", "2"}).out);
  EXPECT_NE(manifest().find(",holes --min-area 2,60,50,bright,1,,999,,1,0,"), std::string::npos)
      << manifest();
  const std::string edges = directory.file("edges.png");
  ASSERT_EQ(run_with({"edges", file, edges, "--operator", "prewitt", "--p1", "20"}).status, 0);
  ASSERT_EQ(run({in, "--p1", "20"}, "edges_prewitt").status, 0);
  EXPECT_EQ(bytes_of(result("40.png")), bytes_of(edges));
}

TEST_F(BatchCommand, graphs_and_overlays_equal_those_of_the_commands) {
  const std::string file = in + "/40.png";
  const std::vector<std::pair<std::string, Words>> cases = {
      {"graph", {"--prune", "3", "--tolerance", "0.5"}},
      {"holes", {"--min-area", "2"}},
      {"localise", {"--gradient-threshold", "20"}}};
  for (const auto& [command, options] : cases) {
    for (const std::string kind : {"svg", "png"}) {
      fs::remove_all(out);
      Words more = {in, "--overlay", kind};
      more.insert(more.end(), options.begin(), options.end());
      ASSERT_EQ(run(more, command).status, 0);
      EXPECT_EQ(results().size(), 7U);
      const std::string overlay = directory.file("one." + kind);
      Words words = {command, file, "--json", "--overlay", overlay};
      words.insert(words.end(), options.begin(), options.end());
      EXPECT_EQ(bytes_of(result("40.json")), run_with(words).out);
      EXPECT_EQ(bytes_of(result("40." + kind)), bytes_of(overlay));
    }
  }
  EXPECT_NE(manifest().find(",localise --gradient-threshold 20 --overlay png,60,50,"),
            std::string::npos)
      << manifest();
}

/// Of several tables of the same columns.
std::string joined(const std::vector<std::string>& tables) {
  std::string text = tables.front();
  for (std::size_t i = 1; i < tables.size(); ++i) {
    text += tables[i].substr(tables[i].find('\n') + 1);
  }
  return text;
}

TEST_F(BatchCommand, the_table_has_the_rows_of_all_images) {
  const std::string csv = directory.file("all.csv");
  for (const std::string command : {"holes", "localise", "graph"}) {
    std::vector<std::string> tables;
    for (const std::string name : {"40", "50", "60"}) {
      const std::string one = directory.file(name + ".csv");
      ASSERT_EQ(run_with({command, in + "/" + name + ".png", "--csv", one}).status, 0);
      tables.push_back(bytes_of(one));
    }
    ASSERT_EQ(run({in, "--table", csv}, command).status, 0);
    EXPECT_EQ(bytes_of(csv), joined(tables));
  }
}

TEST_F(BatchCommand, a_table_of_lines_has_the_json_of_each_image) {
  const std::string lines = directory.file("all.jsonl");
  ASSERT_EQ(run({in, "--table", lines}, "graph").status, 0);
  std::istringstream text(bytes_of(lines));
  for (const std::string name : {"40", "50", "60"}) {
    std::string line;
    ASSERT_TRUE(std::getline(text, line));
    EXPECT_EQ(nlohmann::json::parse(line), nlohmann::json::parse(bytes_of(result(name + ".json"))));
  }
}

TEST_F(BatchCommand, rows_of_pages_have_their_numbers) {
  write_pages("pages.tif", {40, 50});
  const std::string csv = result("all.csv");  // in the directory of the results
  ASSERT_EQ(run({directory.file("pages.tif"), "--table", csv}, "holes").status, 0);
  EXPECT_NE(bytes_of(csv).find("pages.tif,1,60,50,object,1,"), std::string::npos) << bytes_of(csv);
  EXPECT_NE(bytes_of(csv).find("pages.tif,2,70,50,object,1,"), std::string::npos) << bytes_of(csv);
}

TEST_F(BatchCommand, each_shard_has_its_own_table) {
  const std::string csv = directory.file("all.csv");
  ASSERT_EQ(run({in, "--table", csv, "--shard", "2/2"}, "holes").status, 0);
  EXPECT_FALSE(fs::exists(csv));
  const std::string text = bytes_of(directory.file("all_2_of_2.csv"));
  EXPECT_EQ(std::ranges::count(text, '\n'), 3) << text;
  EXPECT_NE(text.find("/50.png,1,"), std::string::npos);
}

TEST_F(BatchCommand, a_table_replaces_no_other_file_of_the_batch) {
  EXPECT_EQ(failure({in, "--table", "a.txt"}, 2, "holes"),
            "--table: expected a name that ends in .csv or .jsonl, got 'a.txt'");
  EXPECT_NE(failure({in, "--table", out + "/./manifest.csv"}, 2, "holes").find("would replace"),
            std::string::npos);
  fs::rename(in + "/40.png", in + "/40.csv");
  EXPECT_NE(failure({in + "/40.csv", "--table", in + "/40.csv"}, 2, "holes").find("would replace"),
            std::string::npos);
  EXPECT_NE(failure({in, "--table", directory.file("no/a.csv")}, 1, "holes").find("no directory"),
            std::string::npos);
}

TEST_F(BatchCommand, overlays_replace_no_input) {
  EXPECT_EQ(failure_of({"batch", "holes", in, "--out", in, "--overlay", "png"}, 1),
            "the result of '" + in + "/40.png' would replace the input '" + in +
                "/40.png'; choose another --out");
}

TEST_F(BatchCommand, images_that_differ_in_their_extension_keep_it) {
  write_bar("in/test1.png", 30);
  write_bar("in/test1.bmp", 20);
  EXPECT_EQ(run({in}).status, 0);
  EXPECT_EQ(read_grey(result("test1.png.png")).width(), 50);
  EXPECT_EQ(read_grey(result("test1.bmp.png")).width(), 40);
  EXPECT_TRUE(fs::exists(result("40.png")));
}

TEST_F(BatchCommand, two_inputs_with_one_output_fail_alone) {
  fs::create_directory(directory.file("other"));
  write_bar("other/40.png", 20);
  write_bar("other/70.png", 50);
  EXPECT_EQ(failure({in, directory.file("other"), "--on-error", "stop"}, 1).find("'"), 0U);
  const ProgramRun made = run({in, directory.file("other")});
  EXPECT_EQ(made.status, 1);
  EXPECT_NE(made.err.find("would become '40.png.png', as does '" + in + "/40.png'"),
            std::string::npos)
      << made.err;
  EXPECT_EQ(read_grey(result("40.png.png")).width(), 60);
  EXPECT_TRUE(fs::exists(result("70.png")));
}

TEST_F(BatchCommand, result_that_would_replace_an_input_is_rejected) {
  const std::string before = bytes_of(in + "/40.png");
  EXPECT_EQ(failure_of({"batch", "thin_guo_hall", in, "--out", in}, 1),
            "the result of '" + in + "/40.png' would replace the input '" + in +
                "/40.png'; choose another --out");
  EXPECT_EQ(bytes_of(in + "/40.png"), before);
}

TEST_F(BatchCommand, what_does_not_exist_is_rejected_before_anything_is_written) {
  EXPECT_EQ(failure({in}, 2, "thin_guo_hal"),
            "no rule is named 'thin_guo_hal'; did you mean 'thin_guo_hall'?");
  EXPECT_EQ(failure({in, "--border", "keep"}, 2, "holes"), "holes has no option --border");
  EXPECT_EQ(failure({in, "--min-area", "3"}, 2), "thin_guo_hall has no option --min-area");
  EXPECT_EQ(failure({in, "--p1", "3"}, 2), "thin_guo_hall has no option --gradient-threshold");
  EXPECT_EQ(failure({in, "--prune", "3"}, 2, "holes"), "holes has no option --prune");
  EXPECT_EQ(failure({in, "--min-area", "3"}, 2, "graph"), "graph has no option --min-area");
  EXPECT_EQ(failure({in, "--overlay", "svg"}, 2), "thin_guo_hall has no option --overlay");
  EXPECT_EQ(failure({in, "--table", "a.csv"}, 2, "edges"), "edges has no option --table");
  EXPECT_EQ(failure({in, "--thinning", "thin_gu"}, 2, "graph").substr(0, 26),
            "no rule is named 'thin_gu'");
  EXPECT_EQ(failure({in + "/*.gif"}, 1), "no file matches '" + in + "/*.gif'");
  fs::create_directory(directory.file("none"));
  EXPECT_EQ(failure({directory.file("none")}, 1), "there is no image file in what was named");
}

}  // namespace
}  // namespace thinbench
