// Named rules: Octave's results, definitions, hand-worked images.

#include "thinbench/named_rules.hpp"

#include <string>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "rules/recorded_tables.hpp"
#include "support/five_by_five.hpp"
#include "support/made_image.hpp"
#include "support/reference_thinning.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

const NamedRule& rule_named(const char* name) {
  const NamedRule* const rule = find_named_rule(name);
  EXPECT_NE(rule, nullptr) << name;
  return *rule;
}

ByteImage applied(const NamedRule& rule, const ByteImage& image, int max_iterations) {
  ByteImage result(image.width(), image.height());
  reference::apply_tables(rule.sub_iterations, {rule.border, max_iterations}, image.view(),
                          result.view());
  return result;
}

TextImage applied_to(const char* name, const TextImage& image) {
  const NamedRule& rule = rule_named(name);
  return text_of(applied(rule, image_of(image), rule.max_iterations));
}

TEST(NamedRules, are_sorted_complete_and_found_by_name) {
  std::string before;
  for (const NamedRule& rule : named_rules()) {
    EXPECT_LT(before, rule.name);
    before = rule.name;
    EXPECT_EQ(find_named_rule(rule.name), &rule);
    EXPECT_FALSE(rule.description.empty() || rule.source.empty()) << rule.name;
    EXPECT_TRUE(rule.sub_iterations.size() >= 1 && rule.sub_iterations.size() <= 8) << rule.name;
    EXPECT_EQ(Rule::named(rule.name).name(), rule.name);
    EXPECT_EQ(Rule::named(rule.name).border(), rule.border);
    EXPECT_EQ(Rule::named(rule.name).max_iterations(), rule.max_iterations);
  }
  EXPECT_EQ(named_rules().size(), 19U);
  EXPECT_EQ(find_named_rule("Life"), nullptr);
}

TEST(NamedRules, those_without_a_limit_only_remove_pixels) {
  for (const NamedRule& rule : named_rules()) {
    if (rule.max_iterations == 1) continue;
    EXPECT_EQ(rule.max_iterations, kUnlimited) << rule.name;
    for (const WindowTable& table : rule.sub_iterations) {
      for (std::size_t window = 0; window < WindowTable::kWindows; ++window) {
        EXPECT_TRUE(!table[window] || (window >> WindowTable::kCentre & 1) != 0) << rule.name;
      }
    }
  }
}

TEST(NamedRules, equal_the_operations_of_octave_on_all_windows) {
  const nlohmann::json tables = recorded().at("bwmorph").at("tables");
  ASSERT_EQ(tables.size(), 11U);
  for (const auto& [name, table] : tables.items()) {
    EXPECT_EQ(rule_named(name.c_str()).sub_iterations.front(), recorded_table(table)) << name;
  }
}

TEST(NamedRules, have_the_tables_of_notations) {
  EXPECT_EQ(rule_named("life").sub_iterations.front(), table_from_hensel("B3/S23"));
  const std::vector<std::string> dilation = {"4:(... .0. .1.)->1", "4:(... .0. ..1)->1"};
  const std::vector<std::string> erosion = {"4:(... .1. .0.)->0", "4:(... .1. ..0)->0"};
  EXPECT_EQ(rule_named("dilate").sub_iterations.front(), table_from_patterns(dilation));
  EXPECT_EQ(rule_named("erode").sub_iterations.front(), table_from_patterns(erosion));
}

TEST(NamedRules, thin_is_guo_hall_in_the_order_of_scikit_image) {
  for (const int limit : {1, 2, kUnlimited}) {
    const ByteImage image = noise_image(90, 70, 85, 4, 3);
    const Thinned expected =
        thinned_by_reference(Rule::guo_hall_skimage, image, {Border::background, limit});
    EXPECT_TRUE(equal(applied(rule_named("thin"), image, limit).view(), expected.image.view()));
  }
}

TEST(NamedRules, hit_or_miss_sets_remove_what_their_first_and_second_element_match) {
  const auto removed_by = [](const char* name, std::size_t sub) {
    const WindowTable table = rule_named(name).sub_iterations[sub];
    std::vector<std::string> windows;
    for (std::size_t window = 0; window < WindowTable::kWindows; ++window) {
      if ((window >> WindowTable::kCentre & 1) == 0 || table[window]) continue;
      std::string text;
      for (int k = 0; k < 9; ++k) text += (window >> k & 1) != 0 ? '1' : '0';
      windows.push_back(text);
    }
    return windows;
  };
  using Windows = std::vector<std::string>;
  const Windows north = {"000010111", "000110111", "000011111", "000111111"};
  EXPECT_EQ(removed_by("golay_l", 0), north);
  EXPECT_EQ(removed_by("gonzalez_woods", 0), north);
  EXPECT_EQ(removed_by("golay_l", 1).size(), 8U);  // .00 110 .1.
  EXPECT_EQ(removed_by("gonzalez_woods", 1),       // .00 110 11.
            (Windows{"000110110", "100110110", "000110111", "100110111"}));
  EXPECT_EQ(removed_by("golay_l", 2),  // 1.0 110 1.0
            (Windows{"100110100", "110110100", "100110110", "110110110"}));
  EXPECT_EQ(removed_by("prune", 0).size(), 4U);
  EXPECT_EQ(removed_by("prune", 4), (Windows{"100010000"}));
}

TEST(NamedRules, hit_or_miss_thinning_keeps_topology_on_all_images_of_4_x_4) {
  for (const char* name : {"golay_l", "gonzalez_woods"}) {
    const NamedRule& rule = rule_named(name);
    for (std::uint64_t bits = 0; bits < 65536; ++bits) {
      const ByteImage thinned = applied(rule, image_of_bits(4, 4, bits), kUnlimited);
      std::uint32_t before = 0;
      std::uint32_t after = 0;
      for (int i = 0; i < 16; ++i) {
        const int place = i / 4 * 5 + i % 4;
        before |= static_cast<std::uint32_t>(bits >> i & 1) << place;
        after |= (thinned.at(i % 4, i / 4) != 0 ? 1U : 0U) << place;
      }
      ASSERT_TRUE(
          five_by_five::same_topology(five_by_five::cell_of(before), five_by_five::cell_of(after)))
          << name << ' ' << bits;
    }
  }
}

TEST(NamedRules, hand_worked_images) {
  EXPECT_EQ(applied_to("golay_l", {"##", "##"}), (TextImage{"#.", ".#"}));
  EXPECT_EQ(applied_to("prune", {"......", ".####.", "......"}),
            (TextImage{"......", "..##..", "......"}));
}

}  // namespace
}  // namespace thinbench
