#include "thinbench/isa.hpp"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace thinbench {
namespace {

/// Sets the cap for what is started while it lives, and restores what was there.
class CapForChildren {
 public:
  explicit CapForChildren(const char* cap) {
    if (const char* text = std::getenv(kIsaCapVariable)) before_ = text;
    setenv(kIsaCapVariable, cap, 1);
  }
  ~CapForChildren() {
    before_ ? setenv(kIsaCapVariable, before_->c_str(), 1) : unsetenv(kIsaCapVariable);
  }
  CapForChildren(const CapForChildren&) = delete;
  CapForChildren& operator=(const CapForChildren&) = delete;

 private:
  std::optional<std::string> before_;
};

/// The cap is read once in a process: "threadsafe" starts this program again for each EXPECT_EXIT.
class IsaCapDeathTest : public testing::Test {
 protected:
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

/// Ends the process: well where the condition holds.
[[noreturn]] void end_process(bool holds) {
  std::exit(holds ? 0 : 1);
}

/// What is available is what the processor has and `is_allowed` says.
template <class IsAllowed>
bool available_where(const IsAllowed& is_allowed) {
  Isa best = Isa::baseline;
  for (const Isa isa : kAllIsas) {
    const bool expected = is_allowed(isa) && cpu_supports(isa);
    if (isa_available(isa) != expected) return false;
    if (expected) best = isa;
  }
  return best_isa() == best;
}

TEST(Isa, names_and_sets_are_one_to_one) {
  for (const Isa isa : kAllIsas) EXPECT_EQ(isa_from_name(isa_name(isa)), isa);
  EXPECT_EQ(isa_from_name("mmx"), std::nullopt);
}

TEST(Isa, each_set_contains_the_one_before) {
  for (std::size_t i = 1; i < kAllIsas.size(); ++i) {
    EXPECT_LE(cpu_supports(kAllIsas[i]), cpu_supports(kAllIsas[i - 1]));
  }
}

TEST_F(IsaCapDeathTest, hides_every_set_that_it_does_not_contain) {
  const CapForChildren cap("sse4.2");
  EXPECT_EXIT(end_process(isa_cap() == Isa::sse42 &&
                          available_where([](Isa isa) { return isa <= Isa::sse42; })),
              testing::ExitedWithCode(0), "");
}

TEST_F(IsaCapDeathTest, at_the_baseline_leaves_the_baseline) {
  const CapForChildren cap("baseline");
  EXPECT_EXIT(end_process(available_where([](Isa isa) { return isa == Isa::baseline; })),
              testing::ExitedWithCode(0), "");
}

TEST_F(IsaCapDeathTest, that_is_empty_is_no_cap) {
  const CapForChildren cap("");
  EXPECT_EXIT(end_process(isa_cap() == std::nullopt && available_where([](Isa) { return true; })),
              testing::ExitedWithCode(0), "");
}

/// Changes the variable after the first look at it.
bool cap_stays_what_it_was_at_first() {
  const auto first = isa_cap();
  setenv(kIsaCapVariable, "baseline", 1);
  return first == Isa::sse42 && isa_cap() == first;
}

TEST_F(IsaCapDeathTest, is_read_once) {
  const CapForChildren cap("sse4.2");
  EXPECT_EXIT(end_process(cap_stays_what_it_was_at_first()), testing::ExitedWithCode(0), "");
}

/// Writes the error of the cap, if it has one.
[[noreturn]] void end_with_cap_error() {
  try {
    static_cast<void>(isa_cap());
  } catch (const std::invalid_argument& error) {
    std::fputs(error.what(), stderr);
    std::exit(0);
  }
  std::exit(1);
}

TEST_F(IsaCapDeathTest, with_an_unknown_name_is_rejected_and_named) {
  const CapForChildren cap("avx3");
  EXPECT_EXIT(end_with_cap_error(), testing::ExitedWithCode(0),
              "THINBENCH_MAX_ISA: expected one of baseline, sse4.2, avx2, avx512, avx512icl, got "
              "'avx3'");
}

}  // namespace
}  // namespace thinbench
