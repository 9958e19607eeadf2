#include <algorithm>
#include <fstream>
#include <iostream>
#include <regex>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include "batch/manifest_text.hpp"
#include "images/binarise.hpp"
#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/file_size_limit.hpp"
#include "support/temporary_directory.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;
using Words = std::vector<std::string>;

/// A bright bar with a hole.
ByteImage bar(Index size) {
  ByteImage image(size + 20, 50);
  for (Index y = 5; y < 25; ++y) {
    for (Index x = 5; x < size + 15; ++x) image.at(x, y) = 200;
  }
  image.at(10, 12) = 0;
  return image;
}

ByteImage skeleton_of(const ByteImage& grey) {
  ByteImage image = copy_of(grey.view());
  thin(Rule::guo_hall, image.view(), image.view());
  return image;
}

/// All but the seconds, which differ from run to run.
std::string without_seconds(const std::string& manifest) {
  return std::regex_replace(manifest, std::regex(R"((,[0-9]+[.e][0-9.e-]+){3},)"), ",s,");
}

class BatchCommand : public testing::Test {
 protected:
  void SetUp() override {
    for (const Index size : {40, 50, 60}) write_bar("in/" + std::to_string(size) + ".png", size);
  }

  void write_bar(const std::string& name, Index size) const {
    fs::create_directories(fs::path(directory.file(name)).parent_path());
    write_grey(directory.file(name), bar(size).view());
  }
  void write_pages(const std::string& name, const std::vector<Index>& sizes) const {
    std::vector<ByteImage> pages;
    for (const Index size : sizes) pages.push_back(bar(size));
    write_grey_pages(directory.file(name), pages);
  }

  [[nodiscard]] Words words(const Words& more, const std::string& operation) const {
    Words all = {"batch", operation, "--out", out};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  [[nodiscard]] ProgramRun run(const Words& more,
                               const std::string& operation = "thin_guo_hall") const {
    return run_with(words(more, operation));
  }
  /// The error message; checks that nothing was written.
  [[nodiscard]] std::string failure(const Words& more, int status,
                                    const std::string& operation = "thin_guo_hall") const {
    std::string text = failure_of(words(more, operation), status);
    EXPECT_FALSE(fs::exists(out));
    return text;
  }

  [[nodiscard]] std::string result(const std::string& name) const { return out + "/" + name; }
  [[nodiscard]] Names results() const {
    Names names;
    for (const auto& entry : fs::recursive_directory_iterator(out)) {
      if (!entry.is_directory()) names.insert(fs::relative(entry.path(), out));
    }
    return names;
  }
  [[nodiscard]] std::string manifest() const { return bytes_of(result("manifest.csv")); }
  void expect_skeleton(const std::string& name, Index size) const {
    EXPECT_TRUE(equal(read_grey(result(name)).view(), skeleton_of(bar(size)).view())) << name;
  }

  TemporaryDirectory directory;
  std::string in = directory.file("in");
  std::string out = directory.file("out");
};

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
  const Words options = {"--foreground",
                         "dark",
                         "--threshold",
                         "100",
                         "--border",
                         "keep",
                         "--max-iterations",
                         "2",
                         "--technique",
                         "simd_bitpacked",
                         "--isa",
                         "baseline"};
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

TEST_F(BatchCommand, failures_are_counted_listed_and_written_to_the_manifest) {
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

TEST_F(BatchCommand, stops_at_the_first_failure_where_asked_to) {
  static_cast<void>(directory.with("in/0.png", "text"));
  for (Index i = 0; i < 20; ++i) write_bar("in/more" + std::to_string(i) + ".png", 40);
  const ProgramRun ran = run({in, "--on-error", "stop", "--threads", "1"});
  EXPECT_EQ(ran.status, 1);
  EXPECT_NE(ran.out.find(" 1 failed, "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find(" results were not started\n"), std::string::npos) << ran.out;
  EXPECT_FALSE(fs::exists(result("more9.png")));
}

TEST_F(BatchCommand, resume_does_what_is_missing_failed_or_was_done_otherwise) {
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

TEST_F(BatchCommand, resumed_run_ends_with_the_same_manifest_wherever_it_was_killed) {
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

TEST_F(BatchCommand, shards_share_the_inputs) {
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

TEST_F(BatchCommand, two_inputs_with_one_output_are_rejected_by_name) {
  write_bar("in/40.pgm", 40);
  EXPECT_EQ(failure({in}, 1), "'" + in + "/40.pgm' and '" + in +
                                  "/40.png' would both become '40.png'; process them in two runs "
                                  "with different --out");
}

TEST_F(BatchCommand, result_that_would_replace_an_input_is_rejected) {
  const std::string before = bytes_of(in + "/40.png");
  EXPECT_EQ(failure_of({"batch", "thin_guo_hall", in, "--out", in}, 1),
            "the result of '" + in + "/40.png' would replace the input '" + in +
                "/40.png'; choose another --out");
  EXPECT_EQ(bytes_of(in + "/40.png"), before);
}

TEST_F(BatchCommand, full_disk_fails_each_image_and_leaves_no_part_of_it) {
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

TEST_F(BatchCommand, full_disk_under_the_manifest_ends_the_run_with_whole_lines) {
  const FileSizeLimit limit(400);
  EXPECT_EQ(failure_of(words({in, "--format", "pbm"}, "thin_guo_hall"), 1),
            "cannot write '" + result("manifest.csv") + "': File too large");
  EXPECT_EQ(manifest().back(), '\n');
}

TEST_F(BatchCommand, file_that_is_no_manifest_is_never_replaced) {
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
}

TEST_F(BatchCommand, manifest_belongs_to_one_run_at_a_time) {
  const std::string file = directory.with("manifest.csv", "");
  const int descriptor = open(file.c_str(), O_RDWR);
  flock(descriptor, LOCK_EX);
  EXPECT_EQ(failure_of(words({in, "--manifest", file}, "thin_guo_hall"), 1),
            "cannot write '" + file + "': another run is writing to it");
  close(descriptor);
}

TEST_F(BatchCommand, abandoned_temporary_files_are_removed) {
  static_cast<void>(directory.with("out/.thinbench-1.png", "part"));
  EXPECT_EQ(run({in}).status, 0);
  EXPECT_EQ(results(), (Names{"40.png", "50.png", "60.png", "manifest.csv"}));
}

TEST_F(BatchCommand, json_manifest_rejects_names_that_are_not_utf8_and_csv_holds_them) {
  write_bar("in/\xff.png", 40);
  EXPECT_EQ(failure({in, "--manifest", directory.file("m.jsonl")}, 1),
            "a manifest in JSON cannot hold the name '" + in +
                "/\xff.png', which is not UTF-8; use one in CSV");
  EXPECT_EQ(run({in}).status, 0);
  EXPECT_NE(run({in, "--resume"}).out.find(" 4 done before"), std::string::npos);
}

TEST_F(BatchCommand, what_does_not_exist_is_rejected_before_anything_is_written) {
  EXPECT_EQ(failure({in}, 2, "thin_guo_hal"),
            "no operation is named 'thin_guo_hal'; did you mean 'thin_guo_hall'?");
  EXPECT_EQ(failure({in, "--border", "keep"}, 2, "holes"), "holes has no option --border");
  EXPECT_EQ(failure({in, "--min-area", "3"}, 2), "thin_guo_hall has no option --min-area");
  EXPECT_EQ(failure({in, "--p1", "3"}, 2), "thin_guo_hall has no option --gradient-threshold");
  EXPECT_EQ(failure({in + "/*.gif"}, 1), "no file matches '" + in + "/*.gif'");
  fs::create_directory(directory.file("none"));
  EXPECT_EQ(failure({directory.file("none")}, 1), "there is no image file in what was named");
}

}  // namespace
}  // namespace thinbench
