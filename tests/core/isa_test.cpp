#include "thinbench/isa.hpp"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "support/isa_tests.hpp"

namespace thinbench {
namespace {

/// A process reads the cap once; the style "threadsafe" runs each EXPECT_EXIT in a new process.
class IsaCapDeathTest : public testing::Test {
 protected:
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

[[noreturn]] void exit_with(bool success) {
  std::exit(success ? 0 : 1);
}

/// Whether exactly the ISAs that the processor supports, and none later than this, are available.
bool only_available_up_to(Isa last) {
  Isa best = Isa::baseline;
  for (const Isa isa : all_isas()) {
    const bool expected = isa <= last && cpu_supports(isa);
    if (isa_available(isa) != expected) return false;
    if (expected) best = isa;
  }
  return best_isa() == best;
}

TEST(Isa, names_map_to_their_isas_and_unknown_names_to_none) {
  for (const Isa isa : all_isas()) EXPECT_EQ(isa_from_name(isa_name(isa)), isa);
  EXPECT_EQ(isa_from_name("mmx"), std::nullopt);
}

TEST(Isa, each_isa_implies_the_one_before) {
  for (std::size_t i = 1; i < all_isas().size(); ++i) {
    EXPECT_LE(cpu_supports(all_isas()[i]), cpu_supports(all_isas()[i - 1]));
  }
}

TEST_F(IsaCapDeathTest, hides_later_isas_and_none_where_it_is_empty) {
  for (const Isa last : all_isas()) {
    const IsaCap cap(std::string(isa_name(last)).c_str());
    EXPECT_EXIT(exit_with(isa_cap() == last && only_available_up_to(last)),
                testing::ExitedWithCode(0), "");
  }
  const IsaCap cap("");
  EXPECT_EXIT(exit_with(!isa_cap() && only_available_up_to(all_isas().back())),
              testing::ExitedWithCode(0), "");
}

/// Changes the variable after the cap was read.
bool cap_ignores_later_changes() {
  const auto first = isa_cap();
  set_cap("baseline");
  return first == all_isas().back() && isa_cap() == first;
}

TEST_F(IsaCapDeathTest, is_read_once) {
  const IsaCap cap(std::string(isa_name(all_isas().back())).c_str());
  EXPECT_EXIT(exit_with(cap_ignores_later_changes()), testing::ExitedWithCode(0), "");
}

/// Prints the error that reading the cap throws.
[[noreturn]] void print_cap_error_and_exit() {
  try {
    static_cast<void>(isa_cap());
  } catch (const std::invalid_argument& error) {
    std::fputs(error.what(), stderr);
    std::exit(0);
  }
  std::exit(1);
}

TEST_F(IsaCapDeathTest, unknown_name_is_rejected) {
  const IsaCap cap("avx3");
  EXPECT_EXIT(print_cap_error_and_exit(), testing::ExitedWithCode(0),
              "THINBENCH_MAX_ISA: expected one of " + all_isa_names() + ", got 'avx3'");
}

TEST_F(IsaCapDeathTest,
       unknown_name_is_reported_once_where_something_is_computed_and_caps_nothing) {
  const IsaCap cap("avx3");
  const auto compute_twice = [] {
    const bool same = best_isa() == best_isa();
    exit_with(same && isa_available(Isa::baseline) == cpu_supports(Isa::baseline));
  };
  EXPECT_EXIT(compute_twice(), testing::ExitedWithCode(0),
              "^thinbench: THINBENCH_MAX_ISA: expected one of " + all_isa_names() +
                  ", got 'avx3'; there is no cap.?\n$");  // Windows: a carriage return
}

}  // namespace
}  // namespace thinbench
