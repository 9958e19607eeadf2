// What the rules claim of themselves, as properties: topology, idempotence, subset, symmetry.
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/components.hpp"
#include "scene/scene.hpp"
#include "small_images.hpp"
#include "thinbench/thinning.hpp"
#include "thinning/property_pictures.hpp"

namespace thinbench {
namespace {

using property_pictures::marked_outside;
using property_pictures::pictures;
using small_images::Cell;
using small_images::Sheet;

ByteImage thinned(std::string_view operation, const ByteImage& image) {
  ByteImage result(image.width(), image.height());
  thin(operation, image.view(), result.view());
  return result;
}

ByteImage turned(const ByteImage& image) {
  ByteImage result(image.height(), image.width());
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) result.at(y, image.width() - 1 - x) = image.at(x, y);
  }
  return result;
}

std::vector<std::string> thinning_rules() {
  std::vector<std::string> names;
  for (const ThinningOperation& operation : thinning_operations()) {
    const bool is_rule = operation.default_model == nullptr && !operation.takes_directions;
    if (is_rule) names.emplace_back(operation.name);
  }
  return names;
}

std::string picture_text(Cell cell) {
  std::string text = "\n";
  for (int y = 1; y <= small_images::kSide; ++y) {
    for (int x = 1; x <= small_images::kSide; ++x) {
      text += (cell >> (8 * y + x) & 1) != 0 ? '#' : '.';
    }
    text += '\n';
  }
  return text;
}

/// The first image of 5 x 5 pixels whose topology an operation changes.
std::optional<std::string> changed_five_by_five(std::string_view operation) {
  Sheet sheet;
  for (std::uint32_t first = 0; first < small_images::kCount; first += Sheet::kCells) {
    sheet.fill(first);
    thin(operation, sheet.view(), sheet.view());
    for (std::uint32_t i = 0; i < Sheet::kCells; ++i) {
      const Cell before = small_images::cell_of(first + i);
      const Cell after = sheet.cell(i);
      if (before == after || small_images::same_topology(before, after)) continue;
      return picture_text(before) + "becomes" + picture_text(after);
    }
  }
  return std::nullopt;
}

class KeepsTopology : public testing::TestWithParam<const char*> {};

TEST_P(KeepsTopology, on_all_five_by_five) {
  const auto changed = changed_five_by_five(GetParam());
  EXPECT_FALSE(changed) << changed.value_or("");
}

TEST_P(KeepsTopology, on_pictures) {
  for (const ByteImage& image : pictures()) {
    const ByteImage skeleton = thinned(GetParam(), image);
    EXPECT_EQ(scene_test::objects_of(image.view()).list.size(),
              scene_test::objects_of(skeleton.view()).list.size());
    EXPECT_EQ(scene_test::holes_of(image.view()).size(),
              scene_test::holes_of(skeleton.view()).size());
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, KeepsTopology,
                         testing::Values("thin_guo_hall", "thin_spta", "thin_spta_directional",
                                         "thin_mb2"),
                         [](const auto& tested) { return std::string(tested.param); });

class EveryRule : public testing::TestWithParam<std::string> {};

TEST_P(EveryRule, is_idempotent_and_gives_a_subset) {
  for (const ByteImage& image : pictures()) {
    const ByteImage skeleton = thinned(GetParam(), image);
    EXPECT_TRUE(equal(thinned(GetParam(), skeleton).view(), skeleton.view()));
    EXPECT_EQ(marked_outside(skeleton, image), 0);
  }
}

TEST_P(EveryRule, is_symmetric_under_quarter_turns_where_it_has_one_sub_iteration) {
  const std::string& name = GetParam();
  const bool expected = name == "thin_naccache_shinghal" || name == "thin_mb2";
  bool symmetric = true;
  for (const ByteImage& image : pictures()) {
    const ByteImage skeleton = thinned(name, image);
    symmetric = symmetric && equal(turned(skeleton).view(), thinned(name, turned(image)).view());
  }
  EXPECT_EQ(symmetric, expected);
}

INSTANTIATE_TEST_SUITE_P(Rules, EveryRule, testing::ValuesIn(thinning_rules()),
                         [](const auto& tested) { return tested.param; });

ByteImage block(Index width, Index height) {
  ByteImage image(width + 4, height + 4);
  for (Index y = 2; y < height + 2; ++y) {
    for (Index x = 2; x < width + 2; ++x) image.at(x, y) = 255;
  }
  return image;
}

std::size_t objects_after(std::string_view operation, const ByteImage& image) {
  return scene_test::objects_of(thinned(operation, image).view()).list.size();
}

TEST(Rules, zhang_suen_loses_a_two_by_two_block) {
  EXPECT_EQ(objects_after("thin_zhang_suen", block(2, 2)), 0U);
}

TEST(Rules, guo_hall_keeps_a_two_by_two_block_connected) {
  EXPECT_EQ(objects_after("thin_guo_hall", block(2, 2)), 1U);
}

TEST(Rules, naccache_shinghal_loses_bars_of_even_width) {
  for (const Index length : {2, 3, 8, 19}) {
    EXPECT_EQ(objects_after("thin_naccache_shinghal", block(2, length)), 0U) << length;
    EXPECT_EQ(objects_after("thin_naccache_shinghal", block(3, length + 2)), 1U) << length;
  }
}

TEST(Rules, naccache_shinghal_breaks_a_slanted_line_of_even_width) {
  ByteImage line(60, 60);
  for (Index i = 2; i < 50; ++i) line.at(i, i) = line.at(i + 1, i) = 255;
  ASSERT_EQ(scene_test::objects_of(line.view()).list.size(), 1U);
  EXPECT_EQ(objects_after("thin_naccache_shinghal", line), 2U);
}

TEST(Rules, those_that_change_topology_are_caught_on_five_by_five) {
  EXPECT_TRUE(changed_five_by_five("thin_zhang_suen"));
  EXPECT_TRUE(changed_five_by_five("thin_naccache_shinghal"));
}

TEST(SmallImages, topology_by_bits_tells_rings_from_discs_and_one_object_from_two) {
  const Cell ring = small_images::cell_of(0x1F8C63F);
  const Cell disc = small_images::cell_of(0x1FFFFFF);
  EXPECT_EQ(small_images::euler_number(ring), 0);
  EXPECT_EQ(small_images::euler_number(disc), 1);
  EXPECT_FALSE(small_images::same_topology(disc, ring));
  EXPECT_TRUE(small_images::same_topology(disc, Cell{1} << 27));
  EXPECT_FALSE(small_images::same_topology(disc, 0));
  EXPECT_FALSE(small_images::same_topology(disc, Cell{1} << 27 | Cell{1} << 29));
}

}  // namespace
}  // namespace thinbench
