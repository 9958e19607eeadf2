// Every available row against its reference on every set of test images.
#include <gtest/gtest.h>

#include "harness/verify.hpp"

namespace thinbench {
namespace {

using Case = std::tuple<std::size_t, std::size_t>;  // set of images, operation

class Crosscheck : public testing::TestWithParam<Case> {};

/// Nets that repeat their passes are shown the smaller sets: the big ones are for single passes,
/// which are the same code, and for rules.
bool left_out(const TestImageSet& set, const ThinningOperation& operation) {
  const bool repeats_a_net = operation.default_model != nullptr && operation.most_passes > 1;
  return repeats_a_net && (set.name == "sizes" || set.name == "four_by_four");
}

TEST_P(Crosscheck, every_available_row_equals_its_reference) {
  const TestImageSet& set = test_image_sets()[std::get<0>(GetParam())];
  const ThinningOperation& operation = thinning_operations()[std::get<1>(GetParam())];
  if (left_out(set, operation)) GTEST_SKIP() << "covered by the operation's single pass";
  Verifier verifier(matching_rows(std::string("^").append(operation.name).append("/"), {2, 7}));
  set.generate([&](const TestImage& image) { verifier.show(image); });
  for (std::size_t row = 0; row < verifier.rows().size(); ++row) {
    EXPECT_EQ(verifier.verdict(row).first_mismatch, "");
  }
  const VerifySummary summary = summary_of(verifier);
  EXPECT_GT(summary.passed, 0) << "no row ran";
  std::printf("%d rows equal to the reference, %d not available here\n", summary.passed,
              summary.skipped);
}

std::string case_name(const testing::TestParamInfo<Case>& tested) {
  return std::string(thinning_operations()[std::get<1>(tested.param)].name) + "_on_" +
         test_image_sets()[std::get<0>(tested.param)].name;
}

INSTANTIATE_TEST_SUITE_P(
    All, Crosscheck,
    testing::Combine(testing::Range<std::size_t>(0, test_image_sets().size()),
                     testing::Range<std::size_t>(0, thinning_operations().size())),
    case_name);

}  // namespace
}  // namespace thinbench
