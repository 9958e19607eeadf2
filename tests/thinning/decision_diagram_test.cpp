#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "thinning/all_neighbourhoods.hpp"
#include "thinning/engines/mux_rule.hpp"

namespace thinbench::detail {
namespace {

constexpr RuleTable kTable = make_rule_table<NaccacheShinghal, 0>();

std::vector<std::uint8_t> random_table(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint8_t> table(256);
  for (std::uint8_t& entry : table) entry = random() & 1;
  return table;
}

void expect_evaluates(const std::vector<std::uint8_t>& table) {
  const MuxProgram program = make_mux_program(table.data());
  ASSERT_LE(program.count, MuxProgram::kMaxNodes);
  for (int word = 0; word < 8; ++word) {
    const std::uint64_t next = MuxRule{program}.next<0>(neighbourhoods_of_word(word));
    for (int bit = 0; bit < 64; ++bit) {
      const int code = 64 * word + bit;
      const bool expected = code >= 256 && table[static_cast<std::size_t>(code & 255)] != 0;
      ASSERT_EQ((next >> bit & 1) != 0, expected) << code;
    }
  }
}

TEST(DecisionDiagram, evaluates_any_table) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) expect_evaluates(random_table(seed));
  expect_evaluates(std::vector<std::uint8_t>(256, 0));
  expect_evaluates(std::vector<std::uint8_t>(256, 1));
  expect_evaluates({kTable.begin() + 256, kTable.end()});
}

TEST(DecisionDiagram, has_at_most_40_nodes_for_the_rule_of_the_paper) {
  EXPECT_LE(make_mux_program(kTable.data() + 256).count, 40);
}

}  // namespace
}  // namespace thinbench::detail
