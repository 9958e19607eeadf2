#include <fstream>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include "batch/manifest_text.hpp"
#include "batch_fixture.hpp"
#include "support/file_size_limit.hpp"

namespace thinbench {
namespace {

using BatchFailures = BatchCommand;

TEST_F(BatchFailures, failures_are_counted_listed_and_written_to_the_manifest) {
  const std::string png = bytes_of("in/60.png");
  put("in/broken.png", png.substr(0, png.size() / 2));
  put("in/empty.jpg", "");
  put("in/new\nline.png", "text");
  fs::create_directory("in/directory.png");
  const ProgramRun ran = batch("thin_guo_hall in");
  EXPECT_EQ(ran.status, 1);
  expect_holds(ran.out, ": 3 images done, 3 failed, ");
  EXPECT_EQ(ran.err.substr(ran.err.find('\n') + 1),
            "3 failures:\n"
            "  cannot read 'in/broken.png': it is damaged: the file is truncated\n"
            "  cannot read 'in/empty.jpg': the file is empty\n"
            "  cannot read 'in/new\\x0aline.png': it is not an image of a known format\n");
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "60.png", "manifest.csv"}));
  const ManifestText text = parse_manifest(manifest(), TableFormat::csv);
  ASSERT_EQ(text.lines.size(), 6U);
  EXPECT_EQ(text.lines[5].output, "new\nline.png");
  EXPECT_TRUE(text.lines[5].failed);
}

TEST_F(BatchFailures, stops_at_the_first_failure_where_asked_to) {
  put("in/0.png", "text");
  for (Index i = 0; i < 20; ++i) write_bar("in/more" + std::to_string(i) + ".png", 40);
  const ProgramRun ran = batch("thin_guo_hall in --on-error stop --threads 1");
  EXPECT_EQ(ran.status, 1);
  expect_holds(ran.out, " 1 failed, ");
  expect_holds(ran.out, " results were not started\n");
  EXPECT_FALSE(fs::exists("out/more9.png"));
}

TEST_F(BatchFailures, resume_does_what_is_missing_failed_or_was_done_otherwise) {
  ASSERT_EQ(batch("thin_guo_hall in in/absent.png").status, 1);
  fs::remove("out/50.png");
  write_bar("in/absent.png", 70);
  expect_holds(done("thin_guo_hall in in/absent.png --resume"),
               ": 2 images done, 0 failed, 2 done before");
  expect_skeleton("50.png", 50);
  expect_skeleton("absent.png", 70);
  expect_holds(done("thin_guo_hall in --resume --border keep"), " 0 done before");
}

TEST_F(BatchFailures, resume_does_again_what_was_made_of_another_image_rule_or_weights) {
  write_bar("other/40.png", 70);
  done("thin_guo_hall in/40.png");
  expect_holds(done("thin_guo_hall other/40.png --resume"), ": 1 image done, 0 failed, 0 done");
  expect_skeleton("40.png", 70);
  put("rule.json", R"({"name": "r", "hensel": "B/S23"})");
  done("rule.json in");
  expect_holds(done("rule.json in --resume"), " 3 done before");
  put("rule.json", R"({"name": "r", "hensel": "B/S8"})");
  expect_holds(done("rule.json in --resume"), " 0 done before");
  done("graph in --thinning rule.json");
  expect_holds(done("graph in --thinning rule.json --resume"), " 3 done before");
  put("rule.json", R"({"name": "r", "hensel": "B/S78"})");
  expect_holds(done("graph in --thinning rule.json --resume"), " 0 done before");
  expect_holds(done("rule.json in --blur 1.0000001"), " 0 done before");
  expect_holds(done("rule.json in --blur 1.0000002 --resume"), " 0 done before");
}

TEST_F(BatchFailures, resumed_run_ends_with_the_same_manifest_wherever_it_was_killed) {
  put("in/45.png", "text");
  fs::create_directory("out");
  for (const std::string file : {"out/manifest.csv", "out/manifest.jsonl"}) {
    const std::string words = "thin_guo_hall in --resume --manifest " + file;
    ASSERT_EQ(batch(words).status, 1);
    const std::string whole = bytes_of(file);
    for (std::size_t size = 0; size < whole.size(); size += 37) {
      std::ofstream(file) << whole.substr(0, size);
      ASSERT_EQ(batch(words).status, 1);
      ASSERT_EQ(without_seconds(bytes_of(file)), without_seconds(whole)) << size;
    }
  }
}

TEST_F(BatchFailures, resumed_run_ends_with_the_same_table_wherever_it_was_killed) {
  put("in/45.png", "text");
  for (const std::string table : {"all.csv", "all.jsonl"}) {
    fs::remove_all("out");
    const std::string words = "graph in --overlay svg --resume --table " + table;
    ASSERT_EQ(batch(words).status, 1);
    const std::string whole = bytes_of(table);
    expect_holds(whole, "60.png");
    const std::string lines = manifest();
    for (std::size_t size = 0; size < lines.size(); size += 101) {
      std::ofstream("out/manifest.csv") << lines.substr(0, size);
      fs::remove(table);
      fs::remove(size % 2 == 0 ? "out/60.svg" : "out/50.json");
      ASSERT_EQ(batch(words).status, 1);
      ASSERT_EQ(bytes_of(table), whole) << size;
      ASSERT_TRUE(fs::exists("out/60.svg"));
    }
  }
}

TEST_F(BatchFailures, a_table_has_no_rows_of_another_operation) {
  done("holes in --min-area 1000");
  put("in/40.png", "text");  // its old result remains
  ASSERT_EQ(batch("holes in --table all.csv").status, 1);
  EXPECT_EQ(bytes_of("all.csv").find("40.png"), std::string::npos);
  expect_holds(bytes_of("all.csv"), "50.png");
}

TEST_F(BatchFailures, a_result_that_was_changed_is_named_and_the_old_table_remains) {
  put("all.csv", "old");
  done("holes in");
  for (const std::string text :
       {"{}", "[1]", "{\"file\":", R"({"file": 1, "objects": [{}]})", ""}) {
    std::ofstream("out/50.json") << text;
    const ProgramRun made = batch("holes in --table all.csv --resume");
    EXPECT_EQ(made.status, 1);
    expect_holds(made.err, "cannot read 'out/50.json': it is not what this batch writes; delete");
    EXPECT_EQ(bytes_of("all.csv"), "old");
  }
  fs::remove("out/50.json");
  done("holes in --table all.csv --resume");
}

TEST_F(BatchFailures, full_disk_fails_each_image_and_leaves_no_part_of_it) {
  write_pages("in/pages.tif", {40, 50});
  write_bar("in/large.png", 30000);
  done("holes in/40.png --manifest full.csv");  // reading has its memory before the limit
  fs::remove_all("out");
  {
    const FileSizeLimit limit(4096);
    EXPECT_EQ(batch("thin_guo_hall in --format pgm --manifest manifest.csv").status, 1);
  }
  EXPECT_EQ(results(), (Names{"40.pgm", "50.pgm", "60.pgm", "pages_page1.pgm", "pages_page2.pgm"}));
  expect_holds(bytes_of("manifest.csv"), "large.pgm': File too large\n");
}

TEST_F(BatchFailures, what_is_no_utf8_in_a_message_is_replaced_in_json) {
  const std::string words =
      "batch thin_guo_hall in --out no\xff --manifest m.jsonl --format pgm --on-error continue";
  const FileSizeLimit limit(1000);
  EXPECT_EQ(typed(words).status, 1);
  expect_holds(bytes_of("m.jsonl"), "File too large");
}

TEST_F(BatchFailures, full_disk_under_the_manifest_ends_the_run_with_whole_lines) {
  const FileSizeLimit limit(400);
  const ProgramRun ran = batch("thin_guo_hall in --format pbm");
  EXPECT_EQ(ran.status, 1);
  EXPECT_EQ(ran.err, "thinbench: cannot write 'out/manifest.csv': File too large\n");
  EXPECT_EQ(manifest().back(), '\n');
}

TEST_F(BatchFailures, no_new_directory_is_left_where_there_can_be_no_manifest) {
  write_bar("in/deep/er/70.png", 70);
  put("table.csv", "no manifest\n");
  for (const std::string manifest : {"table.csv", "absent/manifest.csv"}) {
    expect_rejected({1,
                     "batch holes in --recursive --out out --resume --manifest " + manifest,
                     {"cannot write '" + manifest}});
  }
}

TEST_F(BatchFailures, file_that_is_not_a_manifest_or_belongs_to_another_run_is_never_replaced) {
  put("table.csv", "a,b\n1,2\n");
  put("lines.jsonl", "{\"a\": 1}\n");
  put("held.csv", "");
  const int held = open("held.csv", O_RDWR);
  flock(held, LOCK_EX);
  for (const auto& [file, reason] : std::vector<std::pair<std::string, std::string>>{
           {"table.csv",
            "not a manifest of this program: its first line does not name the columns"},
           {"lines.jsonl", "not a manifest of this program: its first line is not a record"},
           {"held.csv", "another run is writing it"}}) {
    const std::string before = bytes_of(file);
    const ProgramRun ran = batch("thin_guo_hall in --manifest " + file);
    EXPECT_EQ(ran.status, 1);
    expect_holds(ran.err, "cannot write '" + file + "': ");
    expect_holds(ran.err, reason);
    EXPECT_EQ(bytes_of(file), before);
  }
  close(held);
  EXPECT_EQ(table_format("--manifest", "A.CSV"), TableFormat::csv);
}

TEST_F(BatchFailures, abandoned_temporary_files_are_removed) {
  put("out/.thinbench-1.png", "part");
  done("thin_guo_hall in");
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "60.png", "manifest.csv"}));
}

TEST_F(BatchFailures, names_that_are_not_utf8_fail_alone_with_a_json_manifest_and_csv_holds_them) {
  write_bar("in/\xff.png", 40);
  const ProgramRun made = batch("thin_guo_hall in --manifest m.jsonl");
  EXPECT_EQ(made.status, 1);
  expect_holds(made.err, "a manifest in JSON cannot hold the name 'in/\xff.png', which is not");
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "60.png"}));
  done("thin_guo_hall in");
  expect_holds(done("thin_guo_hall in --resume"), " 4 done before");
}

TEST_F(BatchFailures, words_that_cannot_be_done_are_rejected_before_anything_is_written) {
  fs::create_directory("none");
  fs::create_directory_symlink("none", "link");
  fs::copy_file("in/40.png", "40.csv");
  const std::string replaces = "the result of 'in/40.png' would replace the input 'in/40.png'";
  expect_rejected({
      {2, "batch thin_guo_hal in --out out", {"'thin_guo_hal'; did you mean 'thin_guo_hall'?"}},
      {2, "batch fill-holes in --out out", {"no operation is named 'fill-holes'; known: holes, "}},
      {2, "batch edges_sobl in --out out", {"'edges_sobl'; did you mean 'edges_sobel'?"}},
      {2, "batch holes in --out out --null", {"--null needs - as IN"}},
      {2, "batch holes in --out out --border keep", {"holes has no option --border"}},
      {2, "batch guo_hall in --out out --p1 3", {"has no option --gradient-threshold"}},
      {2, "batch graph in --out out --min-area 3", {"graph has no option --min-area"}},
      {2, "batch edges in --out out --table a.csv", {"edges has no option --table"}},
      {2, "batch holes in --out out --format pgm", {"holes has no option --format"}},
      {2, "batch edges in --out out --optimise", {"edges has no option --optimise"}},
      {2, "batch graph in --out out --thinning thin_gu", {"no rule is named 'thin_gu'"}},
      {1, "batch holes in/*.gif --out out", {"no file matches 'in/*.gif'"}},
      {1, "batch holes none --out out", {"there is no image file in what was named"}},
      {1, "batch thin_guo_hall in/40.png --out in", {replaces + "; choose another --out"}},
      {1, "batch holes in/40.png --out in --overlay png", {replaces}},
      {1, "batch holes in --out ./in", {"--out: './in' is a directory of inputs, too"}},
      {2, "batch graph in --out out --unit m\xb5", {"--unit: expected UTF-8 without control"}},
      {2, "batch holes in --out out --table a.txt", {"ends in .csv or .jsonl, got 'a.txt'"}},
      {2, "batch holes in --out out --manifest a.txt", {"ends in .csv or .jsonl, got 'a.txt'"}},
      {2, "batch holes in --out out --table out/./manifest.csv", {"would replace"}},
      {2, "batch holes in --out link/ --table none/manifest.csv", {"would replace"}},
      {2, "batch holes 40.csv --out out --table 40.csv", {"would replace"}},
      {1, "batch holes in --out out --table no/a.csv", {"no directory"}},
  });
  for (const std::string shard : {"0/2", "3/2", "1", "1/0", "a/b", "1/2000000"}) {
    expect_rejected({2,
                     "batch holes in --out out --shard " + shard,
                     {"expected I/N with 1 <= I <= N <= 1000000, got '" + shard + "'"}});
  }
}

}  // namespace
}  // namespace thinbench
