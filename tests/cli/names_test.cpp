#include "cli/names.hpp"

#include <gtest/gtest.h>

namespace thinbench {
namespace {

const std::vector<std::string_view> kKnown = {"baseline", "sse4.2", "avx2", "avx512", "avx512icl"};

TEST(NearestName, tolerates_typing_errors_and_capitals) {
  EXPECT_EQ(nearest_name("sse42", kKnown), "sse4.2");
  EXPECT_EQ(nearest_name("AVX2", kKnown), "avx2");
  EXPECT_EQ(nearest_name("avx512vl", kKnown), "avx512");
  EXPECT_EQ(nearest_name("bsaeline", kKnown), "baseline");
}

TEST(NearestName, completes_a_prefix) {
  EXPECT_EQ(nearest_name("base", kKnown), "baseline");
  EXPECT_EQ(nearest_name("avx", kKnown), "avx2");
}

TEST(NearestName, is_empty_for_a_different_word) {
  EXPECT_EQ(nearest_name("neon", kKnown), std::nullopt);
  EXPECT_EQ(nearest_name("", kKnown), std::nullopt);
  EXPECT_EQ(nearest_name("avx2", {}), std::nullopt);
}

TEST(Enumeration, joins_words_with_commas_and_and) {
  EXPECT_EQ(enumeration({}), "");
  EXPECT_EQ(enumeration({"a"}), "a");
  EXPECT_EQ(enumeration({"a", "b", "c"}), "a, b and c");
}

}  // namespace
}  // namespace thinbench
