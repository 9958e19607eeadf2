// Commands of thinbench-study on its variants: list, run and verify.
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/thread_team.hpp"
#include "harness/families.hpp"
#include "harness/verify.hpp"
#include "peers/peers.hpp"
#include "support/made_image.hpp"
#include "support/usage.hpp"
#include "support/variant_of.hpp"
#include "techniques/thinning.hpp"
#include "thinbench/edges.hpp"
#include "typed.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

/// Borders and limits are no operations of their own.
std::vector<Operation> listed() {
  std::vector<Operation> operations = operations_with_peers();
  std::erase_if(operations, [](const Operation& one) {
    return one.border == Border::keep || one.max_iterations.has_value();
  });
  return operations;
}

std::size_t catalogue_size() {
  std::size_t rows = 0;
  for (const Operation& operation : listed()) rows += operation.variants.size();
  return rows;
}

/// The lines of `list` after its head.
std::vector<std::string> listed_operations() {
  std::istringstream lines(output_of("list"));
  std::vector<std::string> found;
  for (std::string line; std::getline(lines, line);) found.push_back(line);
  found.erase(found.begin());
  return found;
}

TEST(ListCommand, prints_a_line_for_each_operation) {
  const std::vector<std::string> lines = listed_operations();
  const std::vector<Operation> operations = listed();
  ASSERT_EQ(lines.size(), operations.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::regex pattern(operations[i].name + R"( +[1-9]\d* +\w+/[\w.]+ +\S.*)");
    EXPECT_TRUE(std::regex_match(lines[i], pattern)) << lines[i];
    expect_holds(lines[i], std::string(operations[i].description));
  }
}

TEST(ListCommand, counts_the_librarys_variants_that_run_here_and_names_what_the_library_takes) {
  const IsaCap cap("baseline");
  if (!cap.is_in_force()) GTEST_SKIP() << kCapWasRead;
  int listed = 0;
  for (const std::string& line : listed_operations()) {
    std::istringstream words(line);
    std::string operation;
    std::string variants;
    std::string fastest;
    words >> operation >> variants >> fastest;
    if (operation == "fill_holes") {
      EXPECT_EQ(variants, "2") << "with its one peer 3";
    }
    if (operation != "thin_guo_hall") continue;
    const auto& chosen = chosen_variant(Rule::guo_hall, 1024, 9);
    EXPECT_EQ(fastest, std::string(chosen.technique) + "/baseline");
    ++listed;
  }
  EXPECT_EQ(listed, 1);
}

TEST(ListCommand, variants_are_an_aligned_line_for_every_row) {
  std::istringstream lines(output_of("list --variants"));
  std::string header;
  std::getline(lines, header);
  const std::size_t column = header.find("available");
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line) && !line.empty(); ++rows) {
    const std::string cell = line.substr(column);
    EXPECT_TRUE(cell == "yes" || cell.rfind("no: ", 0) == 0) << line;
  }
  EXPECT_EQ(rows, catalogue_size());
}

TEST(ListCommand, json_says_why_a_row_is_not_available) {
  const IsaCap cap("baseline");
  if (!cap.is_in_force()) GTEST_SKIP() << kCapWasRead;
  const Json list = Json::parse(output_of("list --json"));
  EXPECT_EQ(list.size(), catalogue_size());
  for (const Json& row : list) {
    EXPECT_TRUE(!row["fastest"] || (row["available"] && !row["peer"] && row["threads"] == "1"));
    EXPECT_LE(row["min_pixels"], row["threads"] == "n" ? detail::kMinPixelsForThreads : 0);
    EXPECT_EQ(row["available"], row["isa"] == "baseline" || row["peer"]);
    EXPECT_EQ(row["available"], row["reason"] == "");
  }
}

ByteImage bar() {
  return image_by(90, 40,
                  [](Index x, Index y) { return y >= 10 && y < 30 && x >= 5 && x < 85 ? 255 : 0; });
}

class StudyRun : public Commands {
 protected:
  StudyRun() { write_grey("in.png", bar().view()); }

  static ProgramRun run(const std::string& operation_and_words) {
    return typed("run " + operation_and_words + " in.png out.png --threshold 128");
  }
};

TEST_F(StudyRun, computes_the_pixels_of_the_library_by_the_requested_variant) {
  const ByteImage expected = thinned(Rule::guo_hall, bar());
  for (const std::string technique : {"lut", "bitpacked", "simd_bitpacked"}) {
    const ProgramRun ran = run("thin_guo_hall --isa baseline --technique " + technique);
    expect_begins(ran.out + ran.err,
                  "thin_guo_hall/" + technique + "/baseline/1: 90 x 40, iterations: ");
    expect_image("out.png", expected);
  }
  expect_begins(run("thin_guo_hall --technique bitpacked --isa baseline --threads 3").out,
                "thin_guo_hall/bitpacked/baseline/3: ");
  expect_image("out.png", expected);
}

TEST_F(StudyRun, takes_what_the_library_takes_by_default) {
  const auto& chosen = chosen_variant(Rule::guo_hall, 90, 40);
  const ProgramRun ran = run("thin_guo_hall");
  expect_begins(ran.out + ran.err, "thin_guo_hall/" + std::string(chosen.technique) + "/" +
                                       std::string(isa_name(chosen.isa)) + "/1: ");
}

TEST_F(StudyRun, takes_cases_grey_images_and_other_projects_code) {
  EXPECT_EQ(run("thin_zhang_suen:keep --technique opencv").status, 0);
  expect_image("out.png", thinned(Rule::zhang_suen, bar(), {.border = Border::keep}));
  ByteImage edges(90, 40);
  detect_edges(EdgeOperator::sobel, bar().view(), edges.view());
  EXPECT_EQ(run("edges_sobel --technique simd_16bit --isa baseline").status, 0);
  expect_image("out.png", edges);
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.empty() ? 0 : text.size() - 1;
  const std::size_t start = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
  return text.substr(start == std::string::npos ? 0 : start + 1);
}

using VerifyCommand = Commands;

TEST_F(VerifyCommand, prints_a_summary_and_reports_each_set_once_without_a_terminal) {
  const ProgramRun run = typed("verify --quick --filter thin_naccache_shinghal/bitpacked/");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, "3 passed, 0 failed, 0 skipped\n");  // on 1, 2 and 7 threads
  const std::regex lines(R"((\w+: \d+ images in \d+\.\d s\n){5})");
  EXPECT_TRUE(std::regex_match(run.err, lines)) << run.err;
  EXPECT_EQ(output_of("verify --quick --filter thin_naccache_shinghal/bitpacked/baseline/3 "
                      "--threads 3 --threads 3"),
            "1 passed, 0 failed, 0 skipped\n");
}

TEST_F(VerifyCommand, images_are_binarised_by_the_given_options_with_remarks_once) {
  ByteImage image(30, 20);
  image.at(9, 9) = 200;
  write_grey("a.pgm", image.view());
  const ProgramRun run = typed(
      "verify --quick --filter (thin_naccache_shinghal/bitpacked|edges_sobel/lut)/baseline/1 "
      "--image a.pgm --foreground dark --threshold 90");
  EXPECT_EQ(run.status, 0);
  expect_begins(run.err, "warning: a.pgm: 99.8 % of the image is foreground");
  EXPECT_EQ(run.err.find("warning", 1), std::string::npos) << run.err;
  expect_holds(run.err, "images: 1 images");
}

TEST_F(VerifyCommand, prints_skipped_variants_with_the_reason) {
  const IsaCap cap("baseline");
  if (!cap.is_in_force()) GTEST_SKIP() << kCapWasRead;
  const std::string text =
      output_of("verify --quick --filter thin_naccache_shinghal/autovec/(baseline|avx2)");
  expect_begins(text, "skipped: thin_naccache_shinghal/autovec/avx2/1: ");
  EXPECT_EQ(last_line(text), "1 passed, 0 failed, 1 skipped\n");
}

TEST_F(VerifyCommand, fails_if_every_variant_is_skipped) {
  const IsaCap cap("baseline");
  if (!cap.is_in_force()) GTEST_SKIP() << kCapWasRead;
  const ProgramRun run = typed("verify --filter thin_naccache_shinghal/autovec/avx2");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(last_line(run.out), "0 passed, 0 failed, 1 skipped\n");
  EXPECT_EQ(run.err,
            "thinbench-study: nothing was verified: none of the matching rows is available here\n");
}

TEST_F(VerifyCommand, fails_if_no_variant_matches) {
  const ProgramRun run = typed("verify --filter no_such_row");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "0 passed, 0 failed, 0 skipped\n");
  EXPECT_EQ(
      run.err,
      "thinbench-study: no row matches the filter 'no_such_row'; see 'thinbench-study list'\n");
}

TEST_F(VerifyCommand, verifies_peers_like_variants) {
  EXPECT_EQ(output_of("verify --quick --filter edges_sobel/(opencv|copy)"),
            "3 passed, 0 failed, 0 skipped\n");
}

TEST(VerifyReport, prints_a_mismatch_and_fails) {
  detail::ThinningOperation wrong = detail::study::thinning_operations().front();
  wrong.variants.resize(1);
  wrong.variants.front().make = &detail::make_spta;  // another rule
  const Operation operation = thinning_operation(wrong);
  Verifier verifier({{&operation, &operation.variants.front(), 1, "a/wrong/row/1"}});
  verifier.show({"a block", noise_image(9, 9, 100, 1, 1)});
  std::ostringstream out;
  EXPECT_EQ(report_verdicts(verifier, out), kFailure);
  expect_begins(out.str(), "mismatch: a/wrong/row/1: a block: pixel (");
  EXPECT_EQ(last_line(out.str()), "0 passed, 1 failed, 0 skipped\n");
}

TEST(VerifyReport, reports_that_every_image_is_too_wide) {
  detail::ThinningOperation two = detail::study::thinning_operations().front();
  two.variants = {two.variants.front(), two.variants.front()};
  two.variants[0].max_width = 4;
  const Operation operation = thinning_operation(two);
  Verifier verifier({{&operation, &operation.variants[0], 1, "a/narrow/row/1"},
                     {&operation, &operation.variants[1], 1, "a/wide/row/1"}});
  verifier.show({"wide", ByteImage(9, 9)});
  std::ostringstream out;
  EXPECT_EQ(report_verdicts(verifier, out), kSuccess);
  EXPECT_EQ(out.str(),
            "skipped: a/narrow/row/1: every image is wider than its limit\n"
            "1 passed, 0 failed, 1 skipped\n");
}

}  // namespace
}  // namespace thinbench
