// Every available row against its reference on every set of test images.
#include <gtest/gtest.h>

#include "harness/verify.hpp"

namespace thinbench {
namespace {

class Crosscheck : public testing::TestWithParam<std::size_t> {};

TEST_P(Crosscheck, every_available_row_equals_its_reference) {
  Verifier verifier(matching_rows("", {2, 7}));
  test_image_sets()[GetParam()].generate([&](const TestImage& image) { verifier.show(image); });
  for (std::size_t row = 0; row < verifier.rows().size(); ++row) {
    EXPECT_EQ(verifier.verdict(row).first_mismatch, "");
  }
  const VerifySummary summary = summary_of(verifier);
  EXPECT_GT(summary.passed, 0) << "no row ran";
  std::printf("%d rows equal to the reference, %d not available here\n", summary.passed,
              summary.skipped);
}

INSTANTIATE_TEST_SUITE_P(Sets, Crosscheck, testing::Range<std::size_t>(0, test_image_sets().size()),
                         [](const auto& tested) { return test_image_sets()[tested.param].name; });

}  // namespace
}  // namespace thinbench
