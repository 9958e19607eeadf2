// Rules against the keep table, which was computed from the paper before the code was written,
// their published forms and their circuits; what engines rely on.
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "compile/gate_network.hpp"
#include "compile/rule_body.hpp"
#include "rules/parallel_rules.hpp"
#include "rules/rule_table.hpp"

namespace thinbench::detail {
namespace {

// A hexadecimal number, most significant digit first: bit k is set if a foreground pixel with
// descriptor k is kept.
constexpr std::string_view kKeepTable =
    "ece4ff55ece45f55ffffffff5f5f5f5faca4ff55aca45f550f0fffff0f0f5f5f";

bool is_kept_by_table(std::size_t k) {
  const char digit = kKeepTable[63 - k / 4];
  const int value = digit <= '9' ? digit - '0' : digit - 'a' + 10;
  return (value >> (k % 4) & 1) != 0;
}

constexpr RuleTable kTable = make_rule_table<NaccacheShinghal, 0>();

TEST(NaccacheShinghal, circuit_equals_the_keep_table_and_keeps_176_descriptors) {
  int kept = 0;
  for (std::size_t k = 0; k < 256; ++k) {
    EXPECT_EQ(kTable[256 + k] != 0, is_kept_by_table(k)) << k;
    kept += kTable[256 + k];
  }
  EXPECT_EQ(kept, 176);
}

/// Neighbourhoods 64 * word to 64 * word + 63, one per bit. Bit i of a number is n_i, bit 8 is p.
Neighbourhood<std::uint64_t> neighbourhoods_of_word(int word) {
  const auto input = [word](int variable) { return counting_pattern(variable, word); };
  return {input(8), input(0), input(1), input(2), input(3), input(4), input(5), input(6), input(7)};
}

/// The neighbourhood in bit `bit` of every word.
template <class Lane>
Neighbourhood<Lane> neighbourhood_at(const Neighbourhood<std::uint64_t>& n, int bit) {
  const auto at = [bit](std::uint64_t word) { return static_cast<Lane>(word >> bit & 1); };
  return {at(n.p), at(n.n0), at(n.n1), at(n.n2), at(n.n3), at(n.n4), at(n.n5), at(n.n6), at(n.n7)};
}

template <class Rule, int sub>
void expect_next_equals_published_form() {
  for (int word = 0; word < 8; ++word) {
    const Neighbourhood<std::uint64_t> n = neighbourhoods_of_word(word);
    const std::uint64_t next = Rule::template next<sub>(n);
    for (int bit = 0; bit < 64; ++bit) {
      EXPECT_EQ(next >> bit & 1,
                Rule::template published<sub>(neighbourhood_at<std::uint8_t>(n, bit)))
          << "neighbourhood " << 64 * word + bit << ", sub-iteration " << sub;
    }
  }
}

template <class Rule>
void expect_definition() {
  if constexpr (requires { Rule::template published<0>(Neighbourhood<std::uint8_t>{}); }) {
    [&]<int... subs>(std::integer_sequence<int, subs...>) {
      (expect_next_equals_published_form<Rule, subs>(), ...);
    }
    (std::make_integer_sequence<int, Rule::kSubIterations>{});
  }
}

TEST(ParallelRules, equal_their_published_forms) {
  for_each_parallel_rule([]<class Type>(BuiltInRule rule) {
    SCOPED_TRACE(rule_name(rule));
    expect_definition<Type>();
  });
}

template <std::size_t count>
WindowTable output_table(const Circuit<count>& circuit) {
  return tables_of({{circuit.gates.begin(), circuit.gates.end()}, 0}).back();
}

template <class Type, BuiltInRule rule, int sub>
void expect_circuits() {
  if constexpr (!kThreeInputCircuit<rule, sub>.gates.empty()) {
    const WindowTable table = make_window_table_of<Type, sub>();
    EXPECT_EQ(output_table(kThreeInputCircuit<rule, sub>), table) << sub;
    EXPECT_EQ(output_table(kTwoInputCircuit<rule, sub>), table) << sub;
  }
}

TEST(ParallelRules, equal_their_circuits) {
  for_each_parallel_rule([]<class Type>(auto rule) {
    SCOPED_TRACE(rule_name(rule));
    if constexpr (!TwoStageRule<Type>) {
      [&]<int... subs>(std::integer_sequence<int, subs...>) {
        (expect_circuits<Type, decltype(rule)::value, subs>(), ...);
      }
      (std::make_integer_sequence<int, Type::kSubIterations>{});
    }
  });
}

/// All bits of n_i are bit i of `descriptor`; p equals n_0.
Neighbourhood<std::uint64_t> broadcast(int descriptor) {
  const auto all = [=](int i) { return (descriptor >> i & 1) != 0 ? ~std::uint64_t{0} : 0; };
  return {all(0), all(0), all(1), all(2), all(3), all(4), all(5), all(6), all(7)};
}

TEST(Mb2, circuit_equals_the_published_form_for_all_pixels_and_features) {
  for (int features = 0; features < 256; ++features) {
    const Neighbourhood<std::uint64_t> interior = broadcast(features);
    for (int word = 0; word < 8; ++word) {
      const Neighbourhood<std::uint64_t> n = neighbourhoods_of_word(word);
      const std::uint64_t next = Mb2::next<0>(n, interior);
      for (int bit = 0; bit < 64; ++bit) {
        ASSERT_EQ(next >> bit & 1, Mb2::published<0>(neighbourhood_at<std::uint8_t>(n, bit),
                                                     neighbourhood_at<std::uint8_t>(interior, bit)))
            << "neighbourhood " << 64 * word + bit << ", features " << features;
      }
    }
  }
}

/// A feature that exists with fewer foreground pixels exists with more.
template <class Rule>
void expect_removals_make_no_feature() {
  for (int foreground = 0; foreground < 32; ++foreground) {
    for (int removed = 1; removed < 32; removed *= 2) {
      const auto feature_of = [](int pixels) {
        const auto at = [=](int i) { return pixels >> i & 1; };
        return Rule::feature(Cross<int>{at(0), at(1), at(2), at(3), at(4)}) & 1;
      };
      EXPECT_LE(feature_of(foreground & ~removed), feature_of(foreground | removed))
          << foreground << ", " << removed;
    }
  }
}

/// A pixel that is kept with more features is kept with fewer.
template <class Rule, int sub>
void expect_fewer_features_remove_no_more() {
  for (int features = 0; features < 256; ++features) {
    for (int lost = 1; lost < 256; lost *= 2) {
      const Neighbourhood<std::uint64_t> more = broadcast(features | lost);
      const Neighbourhood<std::uint64_t> fewer = broadcast(features & ~lost);
      for (int word = 0; word < 8; ++word) {
        const Neighbourhood<std::uint64_t> n = neighbourhoods_of_word(word);
        const auto kept = [&](const auto& seen) { return Rule::template next<sub>(n, seen); };
        ASSERT_EQ(kept(more) & ~kept(fewer), 0U) << features << ", " << lost;
      }
    }
  }
}

template <class Rule>
void expect_two_stage_laws() {
  if constexpr (TwoStageRule<Rule>) {
    expect_removals_make_no_feature<Rule>();
    [&]<int... subs>(std::integer_sequence<int, subs...>) {
      (expect_fewer_features_remove_no_more<Rule, subs>(), ...);
    }
    (std::make_integer_sequence<int, Rule::kSubIterations>{});
  }
}

// The tile engine relies on it: it skips a pixel if nothing changed within one pixel of it.
TEST(TwoStageRule, removed_pixels_make_no_feature_and_lost_features_remove_no_pixel) {
  for_each_parallel_rule([]<class Type>(BuiltInRule) { expect_two_stage_laws<Type>(); });
}

TEST(ParallelRules, are_visited_in_the_order_of_the_catalogue_and_have_circuits) {
  std::vector<BuiltInRule> rules;
  for_each_parallel_rule([&]<class Type>(BuiltInRule rule) { rules.push_back(rule); });
  std::vector<BuiltInRule> with_circuits;
  for (const RuleInfo& info : kRules) {
    if (detail::body_of(info.rule)->circuits == info.rule) with_circuits.push_back(info.rule);
  }
  EXPECT_EQ(rules, with_circuits);
  EXPECT_GE(rules.size(), 6U);
}

template <class Rule, int sub>
void expect_background_is_kept() {
  for (int word = 0; word < 8; ++word) {
    const Neighbourhood<std::uint64_t> n = neighbourhoods_of_word(word);
    if constexpr (TwoStageRule<Rule>) {
      for (int features = 0; features < 256; ++features) {
        EXPECT_EQ(Rule::template next<sub>(n, broadcast(features)) & ~n.p, 0U);
      }
    } else {
      EXPECT_EQ(Rule::template next<sub>(n) & ~n.p, 0U);
    }
  }
}

TEST(ParallelRules, have_the_reach_of_their_sub_iterations) {
  for_each_parallel_rule([]<class Type>(BuiltInRule rule) {
    const int per_sub_iteration = TwoStageRule<Type> ? 2 : 1;
    EXPECT_EQ(Rule(rule).reach(), Type::kSubIterations * per_sub_iteration) << rule_name(rule);
  });
}

// Keeping the border relies on it: an OR restores removed pixels.
TEST(ParallelRules, only_remove_pixels) {
  for_each_parallel_rule([]<class Type>(BuiltInRule) {
    [&]<int... subs>(std::integer_sequence<int, subs...>) {
      (expect_background_is_kept<Type, subs>(), ...);
    }
    (std::make_integer_sequence<int, Type::kSubIterations>{});
  });
}

}  // namespace
}  // namespace thinbench::detail
