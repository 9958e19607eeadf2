#include "counts/single_steps.hpp"

#include <array>

#include <gtest/gtest.h>

namespace thinbench {
namespace {

constexpr std::uint64_t kEnough = 1000000;

/// Two instructions a turn, and two round them.
void turn(std::uint64_t turns) {
  asm volatile(
      "mov %0, %%rcx\n\t"
      "0: dec %%rcx\n\t"
      "jnz 0b\n\t"
      "nop"
      :
      : "r"(turns)
      : "rcx", "cc");
}

std::uint64_t instructions_of_turns(std::uint64_t turns) {
  return instructions_of([=] { turn(turns); }, kEnough).value_or(0);
}

TEST(SingleSteps, an_empty_call_has_no_instructions) {
  EXPECT_EQ(instructions_of([] {}, kEnough), 0U);
}

TEST(SingleSteps, a_loop_grows_by_its_instructions_for_each_turn) {
  const std::uint64_t once = instructions_of_turns(1);
  EXPECT_GE(once, 4U);
  EXPECT_EQ(instructions_of_turns(2), once + 2);
  EXPECT_EQ(instructions_of_turns(1001), once + 2000);
}

TEST(SingleSteps, an_instruction_that_repeats_itself_counts_once) {
  static std::array<char, 1000> from{};
  static std::array<char, 1000> to{};
  std::size_t count = 10;
  const auto copy = [&] {
    std::size_t bytes = count;
    void* source = from.data();
    void* destination = to.data();
    asm volatile("rep movsb" : "+D"(destination), "+S"(source), "+c"(bytes) : : "memory");
  };
  const auto some = instructions_of(copy, kEnough);
  count = from.size();
  EXPECT_EQ(instructions_of(copy, kEnough), some);
  EXPECT_LT(some.value_or(kEnough), 40U);
}

TEST(SingleSteps, a_call_with_too_many_steps_is_finished_and_not_counted) {
  bool finished = false;
  const auto call = [&] {
    turn(100000);
    finished = true;
  };
  EXPECT_EQ(instructions_of(call, 1000), std::nullopt);
  EXPECT_TRUE(finished);
  EXPECT_EQ(instructions_of([] {}, kEnough), 0U);
}

}  // namespace
}  // namespace thinbench
