#include "core/word.hpp"

#include <gtest/gtest.h>

namespace thinbench {
namespace {

TEST(Word, truth_table_numbers_gates_as_processors_do) {
  constexpr int first = truth_table([](auto a, auto, auto) { return a; });
  constexpr int second = truth_table([](auto, auto b, auto) { return b; });
  constexpr int third = truth_table([](auto, auto, auto c) { return c; });
  constexpr int odd = truth_table([](auto a, auto b, auto c) { return a ^ b ^ c; });
  EXPECT_EQ(first, 0xF0);
  EXPECT_EQ(second, 0xCC);
  EXPECT_EQ(third, 0xAA);
  EXPECT_EQ(odd, 0x96);
}

TEST(Word, neighbours_of_packed_pixels_cross_words) {
  const std::uint64_t words[3] = {std::uint64_t{1} << 63, 0, 1};
  using Traits = WordTraits<std::uint64_t>;
  EXPECT_EQ(Traits::west(words[1], &words[1]), 1U);
  EXPECT_EQ(Traits::east(words[1], &words[1]), std::uint64_t{1} << 63);
}

}  // namespace
}  // namespace thinbench
