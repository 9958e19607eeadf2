// Every available row against its reference on every set of test images.
#include <cstdlib>

#include <gtest/gtest.h>

#include "harness/verify.hpp"

namespace thinbench {
namespace {

struct Case {
  const TestImageSet* set;
  const Operation* operation;
};

void PrintTo(const Case& tested, std::ostream* out) {
  *out << tested.operation->name << " on " << tested.set->name;
}

class Crosscheck : public testing::TestWithParam<Case> {};

/// Nets that repeat their passes are shown the smaller sets: the big ones are for single passes,
/// which are the same code, and for rules.
bool left_out(const TestImageSet& set, const Operation& operation) {
  return operation.small_sets_only && set.name == "sizes";
}

/// Every operation with every set of the kind that it takes.
std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const TestImageSet& set : test_image_sets()) {
    for (const Operation& operation : all_operations()) {
      if (operation.takes == set.kind) cases.push_back({&set, &operation});
    }
  }
  return cases;
}

/// The level whose rows alone are wanted; empty for all.
std::string wanted_level() {
  const char* level = std::getenv("THINBENCH_CROSSCHECK_ISA");
  return level == nullptr ? "" : level;
}

/// The rows of an operation, as a filter.
std::string filter_of(const Operation& operation) {
  const std::string level = wanted_level();
  return "^" + operation.name + (level.empty() ? "/" : "/[^/]+/" + level + "/");
}

TEST_P(Crosscheck, every_available_row_equals_its_reference) {
  const auto& [set, operation] = GetParam();
  if (left_out(*set, *operation)) GTEST_SKIP() << "covered by the operation's single pass";
  const auto level = isa_from_name(wanted_level());
  if (level && !cpu_supports(*level)) GTEST_SKIP() << "this machine lacks " << isa_name(*level);
  Verifier verifier(matching_rows(filter_of(*operation), {2, 7}));
  set->generate([&](const TestImage& image) { verifier.show(image); });
  for (std::size_t row = 0; row < verifier.rows().size(); ++row) {
    EXPECT_EQ(verifier.verdict(row).first_mismatch, "");
  }
  const VerifySummary summary = summary_of(verifier);
  EXPECT_GT(summary.passed, 0) << "no row ran";
  std::printf("%d rows equal to the reference, %d not available here\n", summary.passed,
              summary.skipped);
}

std::string case_name(const testing::TestParamInfo<Case>& tested) {
  return tested.param.operation->name + "_on_" + tested.param.set->name;
}

INSTANTIATE_TEST_SUITE_P(All, Crosscheck, testing::ValuesIn(all_cases()), case_name);

}  // namespace
}  // namespace thinbench
