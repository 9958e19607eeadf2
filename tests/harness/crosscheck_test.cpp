// Compares every available variant with its reference on every set of test images.
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

/// Whether other tests cover these images: the case of one iteration for nets, tests/engines for
/// custom rules.
bool is_omitted(const TestImageSet& set, const Operation& operation) {
  return operation.small_sets_only && set.name == "sizes";
}

/// Patterns are for runs of pixels, which thinning does not have.
bool suits(const TestImageSet& set, const Operation& operation) {
  const bool thins = operation.border || operation.small_sets_only;
  return operation.takes == set.kind && !(thins && set.name == "patterns");
}

/// Every operation with every set that suits it.
std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const TestImageSet& set : test_image_sets()) {
    for (const Operation& operation : all_operations()) {
      if (suits(set, operation)) cases.push_back({&set, &operation});
    }
  }
  return cases;
}

/// The only ISA to verify; empty for all.
std::string requested_isa() {
  const char* isa = std::getenv("THINBENCH_CROSSCHECK_ISA");
  return isa == nullptr ? "" : isa;
}

/// A filter that matches the variants of an operation at the requested ISA.
std::string filter_of(const Operation& operation) {
  const std::string isa = requested_isa();
  return "^" + operation.name + (isa.empty() ? "/" : "/[^/]+/" + isa + "/");
}

/// For slow builds and emulators: 7 means that each operation gets every seventh image of a set.
std::size_t images_per_shown() {
  const char* number = std::getenv("THINBENCH_CROSSCHECK_EVERY");
  return number == nullptr ? 1 : static_cast<std::size_t>(std::max(1, std::atoi(number)));
}

/// Shows a set to a verifier. Operations begin with different images, so that together they see
/// all; each sees one at least.
void show(const TestImageSet& set, std::size_t first, Verifier& verifier) {
  std::size_t size = 0;
  set.generate([&](const TestImage&) { ++size; });
  const std::size_t every = std::min(images_per_shown(), size);
  std::size_t number = first;
  set.generate([&](const TestImage& image) {
    if (number++ % every == 0) verifier.show(image);
  });
}

TEST_P(Crosscheck, every_available_variant_equals_its_reference) {
  const auto& [set, operation] = GetParam();
  if (is_omitted(*set, *operation)) GTEST_SKIP() << "covered by the case of one iteration";
  const auto isa = isa_from_name(requested_isa());
  if (isa && !cpu_supports(*isa)) GTEST_SKIP() << "this machine lacks " << isa_name(*isa);
  Verifier verifier(matching_rows(filter_of(*operation), {2, 7}));
  show(*set, static_cast<std::size_t>(operation - all_operations().data()), verifier);
  long compared = 0;
  for (std::size_t row = 0; row < verifier.rows().size(); ++row) {
    EXPECT_EQ(verifier.verdict(row).first_mismatch, "");
    compared += verifier.verdict(row).compared;
  }
  const VerifySummary summary = summary_of(verifier);
  EXPECT_GT(summary.passed, 0) << "no variant ran";
  std::printf("%d variants equal to the reference in %ld comparisons, %d not available here\n",
              summary.passed, compared, summary.skipped);
}

std::string case_name(const testing::TestParamInfo<Case>& tested) {
  std::string name = tested.param.operation->name + "_on_" + tested.param.set->name;
  std::replace(name.begin(), name.end(), ':', '_');  // ':' is not allowed in test names
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, Crosscheck, testing::ValuesIn(all_cases()), case_name);

}  // namespace
}  // namespace thinbench
