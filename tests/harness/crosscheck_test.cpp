// Every available variant against its reference on every set of test images.
#include <algorithm>
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

/// Nets are shown the large sets with one iteration only: more are the same code.
bool is_omitted(const TestImageSet& set, const Operation& operation) {
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

/// The ISA whose variants alone are wanted; empty for all.
std::string wanted_isa() {
  const char* isa = std::getenv("THINBENCH_CROSSCHECK_ISA");
  return isa == nullptr ? "" : isa;
}

/// The variants of an operation, as a filter.
std::string filter_of(const Operation& operation) {
  const std::string isa = wanted_isa();
  return "^" + operation.name + (isa.empty() ? "/" : "/[^/]+/" + isa + "/");
}

TEST_P(Crosscheck, every_available_variant_equals_its_reference) {
  const auto& [set, operation] = GetParam();
  if (is_omitted(*set, *operation)) GTEST_SKIP() << "covered by the case of one iteration";
  const auto isa = isa_from_name(wanted_isa());
  if (isa && !cpu_supports(*isa)) GTEST_SKIP() << "this machine lacks " << isa_name(*isa);
  Verifier verifier(matching_rows(filter_of(*operation), {2, 7}));
  set->generate([&](const TestImage& image) { verifier.show(image); });
  for (std::size_t row = 0; row < verifier.rows().size(); ++row) {
    EXPECT_EQ(verifier.verdict(row).first_mismatch, "");
  }
  const VerifySummary summary = summary_of(verifier);
  EXPECT_GT(summary.passed, 0) << "no variant ran";
  std::printf("%d variants equal to the reference, %d not available here\n", summary.passed,
              summary.skipped);
}

std::string case_name(const testing::TestParamInfo<Case>& tested) {
  std::string name = tested.param.operation->name + "_on_" + tested.param.set->name;
  std::replace(name.begin(), name.end(), ':', '_');  // GoogleTest takes no other sign
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, Crosscheck, testing::ValuesIn(all_cases()), case_name);

}  // namespace
}  // namespace thinbench
