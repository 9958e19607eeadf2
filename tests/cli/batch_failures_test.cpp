#include <algorithm>
#include <fstream>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include "batch/manifest_text.hpp"
#include "batch_fixture.hpp"
#include "support/file_size_limit.hpp"
#include "support/rejection.hpp"

namespace thinbench {
namespace {

using BatchFailures = BatchCommand;

TEST_F(BatchFailures, failures_are_counted_listed_and_written_to_the_manifest) {
  const std::string png = bytes_of(in + "/60.png");
  static_cast<void>(directory.with("in/broken.png", png.substr(0, png.size() / 2)));
  static_cast<void>(directory.with("in/empty.jpg", ""));
  static_cast<void>(directory.with("in/new\nline.png", "text"));
  fs::create_directory(in + "/directory.png");
  const ProgramRun ran = run({in});
  EXPECT_EQ(ran.status, 1);
  EXPECT_NE(ran.out.find(": 3 images done, 3 failed, "), std::string::npos) << ran.out;
  const std::string list = "3 failures:\n  cannot read '" + in +
                           "/broken.png': it is damaged or has no pixels\n  cannot read '" + in +
                           "/empty.jpg': the file is empty\n  cannot read '" + in +
                           "/new\\x0aline.png': it is not an image of a known format\n";
  EXPECT_EQ(ran.err.substr(ran.err.find('\n') + 1), list);
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "60.png", "manifest.csv"}));
  const ManifestText text = parse_manifest(manifest(), ManifestFormat::csv);
  ASSERT_EQ(text.lines.size(), 6U);
  EXPECT_EQ(text.lines[5].output, "new\nline.png");
  EXPECT_TRUE(text.lines[5].failed);
}

TEST_F(BatchFailures, stops_at_the_first_failure_where_asked_to) {
  static_cast<void>(directory.with("in/0.png", "text"));
  for (Index i = 0; i < 20; ++i) write_bar("in/more" + std::to_string(i) + ".png", 40);
  const ProgramRun ran = run({in, "--on-error", "stop", "--threads", "1"});
  EXPECT_EQ(ran.status, 1);
  EXPECT_NE(ran.out.find(" 1 failed, "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find(" results were not started\n"), std::string::npos) << ran.out;
  EXPECT_FALSE(fs::exists(result("more9.png")));
}

TEST_F(BatchFailures, resume_does_what_is_missing_failed_or_was_done_otherwise) {
  const std::string absent = directory.file("in/absent.png");
  ASSERT_EQ(run({in, absent}).status, 1);
  fs::remove(result("50.png"));
  write_bar("in/absent.png", 70);
  const ProgramRun resumed = run({in, absent, "--resume"});
  EXPECT_EQ(resumed.status, 0);
  EXPECT_NE(resumed.out.find(": 2 images done, 0 failed, 2 done before"), std::string::npos);
  expect_skeleton("50.png", 50);
  expect_skeleton("absent.png", 70);
  EXPECT_NE(run({in, "--resume", "--border", "keep"}).out.find(" 0 done before"),
            std::string::npos);
}

TEST_F(BatchFailures, resumed_run_ends_with_the_same_manifest_wherever_it_was_killed) {
  static_cast<void>(directory.with("in/45.png", "text"));
  for (const std::string name : {"manifest.csv", "manifest.jsonl"}) {
    fs::remove_all(out);
    const std::string file = result(name);
    const Words all = {in, "--manifest", file, "--resume"};
    fs::create_directory(out);
    ASSERT_EQ(run(all).status, 1);
    const std::string whole = bytes_of(file);
    const auto comparable = [](const std::string& text) {
      return std::regex_replace(without_seconds(text), std::regex(R"(seconds":[0-9.e-]+)"), "s");
    };
    for (std::size_t size = 0; size < whole.size(); size += 37) {
      fs::resize_file(file, 0);
      std::ofstream(file) << whole.substr(0, size);
      ASSERT_EQ(run(all).status, 1);
      ASSERT_EQ(comparable(bytes_of(file)), comparable(whole)) << size;
    }
  }
}

TEST_F(BatchFailures, resumed_run_ends_with_the_same_table_wherever_it_was_killed) {
  static_cast<void>(directory.with("in/45.png", "text"));
  for (const std::string name : {"all.csv", "all.jsonl"}) {
    fs::remove_all(out);
    const Words all = {in, "--table", directory.file(name), "--overlay", "svg", "--resume"};
    ASSERT_EQ(run(all, "graph").status, 1);
    const std::string whole = bytes_of(directory.file(name));
    ASSERT_NE(whole.find("60.png"), std::string::npos);
    const std::string lines = manifest();
    for (std::size_t size = 0; size < lines.size(); size += 101) {
      std::ofstream(result("manifest.csv")) << lines.substr(0, size);
      fs::remove(directory.file(name));
      fs::remove(result(size % 2 == 0 ? "60.svg" : "50.json"));
      ASSERT_EQ(run(all, "graph").status, 1);
      ASSERT_EQ(bytes_of(directory.file(name)), whole) << size;
      ASSERT_TRUE(fs::exists(result("60.svg")));
    }
  }
}

TEST_F(BatchFailures, a_table_has_no_rows_of_another_operation) {
  const std::string csv = directory.file("all.csv");
  ASSERT_EQ(run({in, "--min-area", "1000"}, "holes").status, 0);
  static_cast<void>(directory.with("in/40.png", "text"));  // its old result remains
  ASSERT_EQ(run({in, "--table", csv}, "holes").status, 1);
  EXPECT_EQ(bytes_of(csv).find("40.png"), std::string::npos);
  EXPECT_NE(bytes_of(csv).find("50.png"), std::string::npos);
}

TEST_F(BatchFailures, a_result_that_was_changed_is_named_and_the_old_table_remains) {
  const std::string csv = directory.with("all.csv", "old");
  ASSERT_EQ(run({in}, "holes").status, 0);
  for (const std::string text :
       {"{}", "[1]", "{\"file\":", R"({"file": 1, "objects": [{}]})", ""}) {
    std::ofstream(result("50.json")) << text;
    const ProgramRun made = run({in, "--table", csv, "--resume"}, "holes");
    EXPECT_EQ(made.status, 1);
    EXPECT_NE(made.err.find("cannot read '" + result("50.json") +
                            "': it is not what this batch writes; delete it and use --resume"),
              std::string::npos)
        << made.err;
    EXPECT_EQ(bytes_of(csv), "old");
  }
  fs::remove(result("50.json"));
  EXPECT_EQ(run({in, "--table", csv, "--resume"}, "holes").status, 0);
}

TEST_F(BatchFailures, shards_share_the_inputs) {
  ASSERT_EQ(run({in, "--shard", "1/2"}).status, 0);
  EXPECT_EQ(results(), (Names{"40.png", "60.png", "manifest_1_of_2.csv"}));
  ASSERT_EQ(run({in, "--shard", "2/2"}).status, 0);
  EXPECT_EQ(results(),
            (Names{"40.png", "50.png", "60.png", "manifest_1_of_2.csv", "manifest_2_of_2.csv"}));
  EXPECT_EQ(run({in, "--shard", "9/9"}).status, 0);
  fs::remove_all(out);
  for (const std::string text : {"0/2", "3/2", "1", "1/0", "a/b", "1/2000000"}) {
    EXPECT_EQ(failure({in, "--shard", text}, 2),
              "--shard: expected I/N with 1 <= I <= N <= 1000000, got '" + text + "'");
  }
}

TEST_F(BatchFailures, full_disk_fails_each_image_and_leaves_no_part_of_it) {
  write_pages("in/pages.tif", {40, 50});
  ASSERT_EQ(run({in + "/40.png"}).status, 0);
  const std::string manifest_file = directory.file("manifest.csv");
  fs::remove_all(out);
  write_bar("in/large.png", 30000);
  {
    const FileSizeLimit limit(4096);
    EXPECT_EQ(run({in, "--format", "pgm", "--manifest", manifest_file}).status, 1);
  }
  EXPECT_EQ(results(), (Names{"40.pgm", "50.pgm", "60.pgm", "pages_page1.pgm", "pages_page2.pgm"}));
  EXPECT_NE(bytes_of(manifest_file).find("large.pgm': File too large\n"), std::string::npos);
}

TEST_F(BatchFailures, full_disk_under_the_manifest_ends_the_run_with_whole_lines) {
  const FileSizeLimit limit(400);
  EXPECT_EQ(failure_of(words({in, "--format", "pbm"}, "thin_guo_hall"), 1),
            "cannot write '" + result("manifest.csv") + "': File too large");
  EXPECT_EQ(manifest().back(), '\n');
}

TEST_F(BatchFailures, no_new_directory_is_left_where_there_can_be_no_manifest) {
  write_bar("in/deep/er/70.png", 70);
  const std::string table = directory.with("table.csv", "no manifest\n");
  for (const std::string& manifest : {table, directory.file("absent/manifest.csv")}) {
    const Words more = {"batch", "thin_guo_hall", in,           "--recursive", "--out",
                        out,     "--resume",      "--manifest", manifest};
    EXPECT_NE(failure_of(more, 1).find("cannot write '" + manifest), std::string::npos);
    EXPECT_FALSE(fs::exists(out));
  }
}

TEST_F(BatchFailures, file_that_is_no_manifest_is_never_replaced) {
  const std::string table = directory.with("table.csv", "a,b\n1,2\n");
  EXPECT_EQ(failure_of(words({in, "--manifest", table}, "thin_guo_hall"), 1),
            "cannot write '" + table +
                "': it is no manifest of this program: its first line does not name the columns");
  EXPECT_EQ(bytes_of(table), "a,b\n1,2\n");
  const std::string lines = directory.with("lines.jsonl", "{\"a\": 1}\n");
  EXPECT_EQ(failure_of(words({in, "--manifest", lines}, "thin_guo_hall"), 1),
            "cannot write '" + lines +
                "': it is no manifest of this program: its first line is no record");
  EXPECT_EQ(failure_of(words({in, "--manifest", "a.txt"}, "thin_guo_hall"), 2),
            "--manifest: expected a name that ends in .csv or .jsonl, got 'a.txt'");
  EXPECT_EQ(manifest_format("A.CSV"), ManifestFormat::csv);
}

TEST(ManifestText, nested_values_are_no_records) {
  constexpr int depth = 100'000;
  const std::string nested = std::string(depth, '[') + std::string(depth, ']');
  for (const std::string key : {"page", "output", "other"}) {
    const std::string line = R"({"file":"a",")" + key + "\":" + nested + "}\n";
    EXPECT_EQ(rejection_of<std::runtime_error>(
                  [&] { static_cast<void>(parse_manifest(line, ManifestFormat::json_lines)); }),
              "it is no manifest of this program: a line is no record");
  }
}

TEST(ManifestText, values_of_wrong_types_are_no_records) {
  for (const char* line :
       {R"({"file":1,"output":7,"error":null})", R"({"file":1,"page":1e300,"error":null})",
        R"({"file":1,"page":"2","error":null})", R"({"file":1})", R"({"file":)"}) {
    EXPECT_EQ(
        rejection_of<std::runtime_error>([&] {
          static_cast<void>(parse_manifest(std::string(line) + "\n", ManifestFormat::json_lines));
        }),
        "it is no manifest of this program: a line is no record")
        << line;
  }
  const std::string head = manifest_head(ManifestFormat::csv);
  const auto commas = static_cast<std::size_t>(std::count(head.begin(), head.end(), ','));
  const std::string end = std::string(commas - 1, ',') + "\n";
  EXPECT_EQ(parse_manifest(head + "a.png,2" + end, ManifestFormat::csv).lines.front().page, 2);
  for (const char* page : {"", "x", "2x", "99999999999"}) {
    EXPECT_EQ(
        rejection_of<std::runtime_error>([&] {
          static_cast<void>(parse_manifest(head + "a.png," + page + end, ManifestFormat::csv));
        }),
        "it is no manifest of this program: a page has no number")
        << page;
  }
}

TEST_F(BatchFailures, manifest_belongs_to_one_run_at_a_time) {
  const std::string file = directory.with("manifest.csv", "");
  const int descriptor = open(file.c_str(), O_RDWR);
  flock(descriptor, LOCK_EX);
  EXPECT_EQ(failure_of(words({in, "--manifest", file}, "thin_guo_hall"), 1),
            "cannot write '" + file + "': another run is writing it");
  close(descriptor);
}

TEST_F(BatchFailures, abandoned_temporary_files_are_removed) {
  static_cast<void>(directory.with("out/.thinbench-1.png", "part"));
  EXPECT_EQ(run({in}).status, 0);
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "60.png", "manifest.csv"}));
}

TEST_F(BatchFailures, names_that_are_not_utf8_fail_alone_with_a_json_manifest_and_csv_holds_them) {
  write_bar("in/\xff.png", 40);
  const ProgramRun made = run({in, "--manifest", directory.file("m.jsonl")});
  EXPECT_EQ(made.status, 1);
  EXPECT_NE(made.err.find("a manifest in JSON cannot hold the name '" + in +
                          "/\xff.png', which is not UTF-8; use one in CSV"),
            std::string::npos)
      << made.err;
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "60.png"}));
  EXPECT_EQ(run({in}).status, 0);
  EXPECT_NE(run({in, "--resume"}).out.find(" 4 done before"), std::string::npos);
}

}  // namespace
}  // namespace thinbench
