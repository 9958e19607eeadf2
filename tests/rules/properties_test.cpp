// The documented properties of the rules: topology, idempotence, subset, symmetry.
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/five_by_five.hpp"
#include "support/made_image.hpp"
#include "support/property_images.hpp"
#include "support/variant_of.hpp"

namespace thinbench {
namespace {

using five_by_five::Cell;
using five_by_five::Sheet;

ByteImage rotated(const ByteImage& image) {
  return image_by(image.height(), image.width(),
                  [&](Index x, Index y) { return image.at(y, image.height() - 1 - x); });
}

struct TestedRule {
  std::string name;
  Rule rule;
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest's name
void PrintTo(const TestedRule& tested, std::ostream* out) {
  *out << tested.name;
}

TestedRule spta() {
  return {"spta", detail::study::make_rule(detail::study::StudyRule::spta)};
}

/// The product's, and sequential SPTA.
std::vector<TestedRule> tested_rules() {
  std::vector<TestedRule> rules;
  for (const RuleInfo& info : kRules) rules.push_back({std::string(info.name), info.rule});
  rules.push_back(spta());
  return rules;
}

std::vector<TestedRule> rules_that_keep_topology() {
  std::vector<TestedRule> rules = {spta()};
  for (const BuiltInRule rule :
       {Rule::guo_hall, Rule::guo_hall_skimage, Rule::spta_directional, Rule::mb2}) {
    rules.push_back({std::string(rule_name(rule)), rule});
  }
  return rules;
}

std::string test_name(const testing::TestParamInfo<TestedRule>& tested) {
  return tested.param.name;
}

/// By the product or, of sequential SPTA, by the study.
void thin_to(const Rule& rule, const ConstImageView& image, const ImageView& skeleton) {
  if (rule.name() == "spta") {
    thin_by("bitpacked", rule, image, skeleton);
  } else {
    thin(rule, image, skeleton);
  }
}

ByteImage skeleton_of(const Rule& rule, const ByteImage& image) {
  ByteImage skeleton(image.width(), image.height());
  thin_to(rule, image.view(), skeleton.view());
  return skeleton;
}

/// The first image of 5 x 5 pixels whose topology the rule changes, as in image_of_bits(5, 5,
/// code).
std::optional<std::uint32_t> first_topology_change(const Rule& rule) {
  Sheet sheet;
  for (std::uint32_t first = 0; first < five_by_five::kCount; first += Sheet::kCells) {
    sheet.fill(first);
    thin_to(rule, sheet.view(), sheet.view());
    for (std::uint32_t i = 0; i < Sheet::kCells; ++i) {
      const Cell before = five_by_five::cell_of(first + i);
      const Cell after = sheet.cell(i);
      if (before == after || five_by_five::same_topology(before, after)) continue;
      return first + i;
    }
  }
  return std::nullopt;
}

class KeepsTopology : public testing::TestWithParam<TestedRule> {};

TEST_P(KeepsTopology, on_all_five_by_five) {
  EXPECT_EQ(first_topology_change(GetParam().rule), std::nullopt);
}

TEST_P(KeepsTopology, on_noise_and_scenes) {
  for (const ByteImage& image : property_images()) {
    const ByteImage skeleton = skeleton_of(GetParam().rule, image);
    EXPECT_EQ(region_counts(image), region_counts(skeleton));
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, KeepsTopology, testing::ValuesIn(rules_that_keep_topology()),
                         test_name);

class EveryRule : public testing::TestWithParam<TestedRule> {};

TEST_P(EveryRule, is_idempotent_and_gives_a_subset) {
  for (const ByteImage& image : property_images()) {
    const ByteImage skeleton = skeleton_of(GetParam().rule, image);
    EXPECT_TRUE(equal(skeleton_of(GetParam().rule, skeleton).view(), skeleton.view()));
    EXPECT_EQ(pixels_outside(skeleton, image), 0);
  }
}

TEST_P(EveryRule, is_symmetric_under_quarter_turns_if_it_has_one_sub_iteration) {
  const auto& [name, rule] = GetParam();
  const bool expected = name == "naccache_shinghal" || name == "mb2";
  bool symmetric = true;
  for (const ByteImage& image : property_images()) {
    const ByteImage skeleton = skeleton_of(rule, image);
    symmetric =
        symmetric && equal(rotated(skeleton).view(), skeleton_of(rule, rotated(image)).view());
  }
  EXPECT_EQ(symmetric, expected);
}

INSTANTIATE_TEST_SUITE_P(Rules, EveryRule, testing::ValuesIn(tested_rules()), test_name);

ByteImage block(Index width, Index height) {
  return image_by(width + 4, height + 4, [=](Index x, Index y) {
    return x >= 2 && x < width + 2 && y >= 2 && y < height + 2 ? 255 : 0;
  });
}

std::size_t objects_after(BuiltInRule rule, const ByteImage& image) {
  return region_counts(skeleton_of(rule, image)).objects;
}

TEST(Rules, zhang_suen_removes_a_two_by_two_block_and_guo_hall_keeps_one_object) {
  EXPECT_EQ(objects_after(Rule::zhang_suen, block(2, 2)), 0U);
  EXPECT_EQ(objects_after(Rule::guo_hall, block(2, 2)), 1U);
}

TEST(Rules, naccache_shinghal_removes_bars_two_pixels_wide_and_keeps_bars_three_pixels_wide) {
  for (const Index length : {2, 3, 8, 19}) {
    EXPECT_EQ(objects_after(Rule::naccache_shinghal, block(2, length)), 0U) << length;
    EXPECT_EQ(objects_after(Rule::naccache_shinghal, block(3, length + 2)), 1U) << length;
  }
}

TEST(Rules, naccache_shinghal_breaks_a_slanted_line_two_pixels_wide) {
  ByteImage line(60, 60);
  for (Index i = 2; i < 50; ++i) line.at(i, i) = line.at(i + 1, i) = 255;
  ASSERT_EQ(region_counts(line).objects, 1U);
  EXPECT_EQ(objects_after(Rule::naccache_shinghal, line), 2U);
}

TEST(Rules, topology_check_detects_changes_on_five_by_five) {
  EXPECT_TRUE(first_topology_change(Rule::zhang_suen));
  EXPECT_TRUE(first_topology_change(Rule::naccache_shinghal));
}

TEST(TopologyByBits, distinguishes_rings_from_discs_and_one_object_from_two) {
  const Cell ring = five_by_five::cell_of(0x1F8C63F);
  const Cell disc = five_by_five::cell_of(0x1FFFFFF);
  EXPECT_EQ(five_by_five::euler_number(ring), 0);
  EXPECT_EQ(five_by_five::euler_number(disc), 1);
  EXPECT_FALSE(five_by_five::same_topology(disc, ring));
  EXPECT_TRUE(five_by_five::same_topology(disc, Cell{1} << 27));
  EXPECT_FALSE(five_by_five::same_topology(disc, 0));
  EXPECT_FALSE(five_by_five::same_topology(disc, Cell{1} << 27 | Cell{1} << 29));
}

}  // namespace
}  // namespace thinbench
