#include "simd/word.hpp"

#include <gtest/gtest.h>

namespace thinbench::detail {
namespace {

// Not inside the test: Clang 14 crashes on a lambda passed to a consteval function there.
constexpr int kFirst = truth_table([](auto a, auto, auto) { return a; });
constexpr int kSecond = truth_table([](auto, auto b, auto) { return b; });
constexpr int kThird = truth_table([](auto, auto, auto c) { return c; });
constexpr int kOdd = truth_table([](auto a, auto b, auto c) { return a ^ b ^ c; });

TEST(Word, truth_table_has_the_encoding_of_vpternlog) {
  EXPECT_EQ(kFirst, 0xF0);
  EXPECT_EQ(kSecond, 0xCC);
  EXPECT_EQ(kThird, 0xAA);
  EXPECT_EQ(kOdd, 0x96);
}

TEST(Word, neighbours_of_packed_pixels_cross_word_boundaries) {
  const std::uint64_t words[3] = {std::uint64_t{1} << 63, 0, 1};
  using Traits = WordTraits<std::uint64_t>;
  EXPECT_EQ(Traits::west(words[1], &words[1]), 1U);
  EXPECT_EQ(Traits::east(words[1], &words[1]), std::uint64_t{1} << 63);
}

}  // namespace
}  // namespace thinbench::detail
