#include <regex>

#include <gtest/gtest.h>

#include "harness/families.hpp"
#include "harness/verify.hpp"
#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/byte_image.hpp"
#include "support/temporary_directory.hpp"
#include "support/usage.hpp"
#include "techniques/thinning.hpp"

namespace thinbench {
namespace {

std::string last_line(const std::string& text) {
  const std::size_t end = text.empty() ? 0 : text.size() - 1;
  const std::size_t start = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
  return text.substr(start == std::string::npos ? 0 : start + 1);
}

TEST(VerifyCommand, prints_a_summary_and_reports_each_set_once_without_a_terminal) {
  ProgramRun run = run_with({"verify", "--quick", "--filter", "thin_naccache_shinghal/bitpacked/"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, "3 passed, 0 failed, 0 skipped\n");  // on 1, 2 and 7 threads
  const std::regex lines(R"((\w+: \d+ images in \d+\.\d s\n){5})");
  EXPECT_TRUE(std::regex_match(run.err, lines)) << run.err;
  run = run_with({"verify", "--quick", "--filter", "thin_naccache_shinghal/bitpacked/baseline/3",
                  "--threads", "3", "--threads", "3"});
  EXPECT_EQ(run.out, "1 passed, 0 failed, 0 skipped\n");
}

TEST(VerifyCommand, images_are_binarised_by_the_given_options_with_remarks_once) {
  const std::string filter = "(thin_naccache_shinghal/bitpacked|edges_sobel/lut)/baseline/1";
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.pgm");
  ByteImage image(30, 20);
  image.at(9, 9) = 200;
  write_grey(file, image.view());
  const ProgramRun run = run_with({"verify", "--quick", "--filter", filter, "--image", file,
                                   "--foreground", "dark", "--threshold", "90"});
  EXPECT_EQ(run.status, 0);
  const std::string warning = "warning: " + file + ": 99.8 % of the image is foreground";
  EXPECT_EQ(run.err.find(warning), 0U) << run.err;
  EXPECT_EQ(run.err.find("warning", 1), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("images: 1 images"), std::string::npos) << run.err;
}

TEST(VerifyCommand, prints_skipped_variants_with_the_reason) {
  const IsaCap cap("baseline");
  if (!cap.is_in_force()) GTEST_SKIP() << kCapWasRead;
  const ProgramRun run =
      run_with({"verify", "--quick", "--filter", "thin_naccache_shinghal/autovec/(baseline|avx2)"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out.find("skipped: thin_naccache_shinghal/autovec/avx2/1: "), 0U) << run.out;
  EXPECT_EQ(last_line(run.out), "1 passed, 0 failed, 1 skipped\n");
}

TEST(VerifyCommand, fails_if_every_variant_is_skipped) {
  const IsaCap cap("baseline");
  if (!cap.is_in_force()) GTEST_SKIP() << kCapWasRead;
  const ProgramRun run = run_with({"verify", "--filter", "thin_naccache_shinghal/autovec/avx2"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(last_line(run.out), "0 passed, 0 failed, 1 skipped\n");
  EXPECT_EQ(run.err,
            "thinbench-study: nothing was verified: none of the matching rows is available here\n");
}

TEST(VerifyCommand, fails_if_no_variant_matches) {
  const ProgramRun run = run_with({"verify", "--filter", "no_such_row"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "0 passed, 0 failed, 0 skipped\n");
  EXPECT_EQ(
      run.err,
      "thinbench-study: no row matches the filter 'no_such_row'; see 'thinbench-study list'\n");
}

TEST(VerifyCommand, verifies_peers_like_variants) {
  const ProgramRun result =
      run_with({"verify", "--quick", "--filter", "edges_sobel/(opencv|copy)"});
  EXPECT_EQ(result.status, 0) << result.out;
  EXPECT_EQ(result.out, "3 passed, 0 failed, 0 skipped\n");
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
  EXPECT_EQ(out.str().find("mismatch: a/wrong/row/1: a block: pixel ("), 0U) << out.str();
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
