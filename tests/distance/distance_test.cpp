#include "thinbench/distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "reference.hpp"
#include "support/made_image.hpp"
#include "support/variant_of.hpp"

namespace thinbench {
namespace {

using Numbers = std::vector<std::int32_t>;

Numbers distances_of(const ConstImageView& image, const Execution& execution = {}) {
  Numbers numbers(static_cast<std::size_t>(image.width * image.height));
  squared_distances(image, {numbers.data(), image.width, image.height}, execution);
  return numbers;
}

/// Foreground but for one pixel in `rarity`.
std::vector<std::uint8_t> random_pixels(Index count, int rarity, std::mt19937& random) {
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(count));
  for (std::uint8_t& pixel : pixels) pixel = random() % static_cast<unsigned>(rarity) == 0 ? 0 : 9;
  return pixels;
}

TEST(SquaredDistances, of_a_small_image_are_as_worked_by_hand) {
  const ByteImage image = image_of({"#####",  //
                                    "##.##",  //
                                    "#####",  //
                                    "#####"});
  EXPECT_EQ(distances_of(image.view()), (Numbers{5, 2, 1, 2, 5,  //
                                                 4, 1, 0, 1, 4,  //
                                                 5, 2, 1, 2, 5,  //
                                                 8, 5, 4, 5, 8}));
}

TEST(SquaredDistances, of_the_reference_are_those_of_the_formula_for_every_pair_of_pixels) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const Index width = 1 + static_cast<Index>(random() % 40);
    const Index height = 1 + static_cast<Index>(random() % 12);
    auto pixels = random_pixels(width * height, 2 + i, random);
    pixels[random() % pixels.size()] = 0;
    const ConstImageView image(pixels.data(), width, height);
    Numbers found(pixels.size());
    std::vector<double> expected(pixels.size());
    reference::squared_distances(image, {found.data(), width, height});
    reference::distances(image, {expected.data(), width, height}, {});
    for (std::size_t p = 0; p < found.size(); ++p) {
      ASSERT_DOUBLE_EQ(std::sqrt(found[p]), expected[p]) << "image " << i;
    }
  }
}

/// Results of 4 MB and more are written in another way, and such images are cut into strips.
TEST(SquaredDistances, of_large_images_with_distant_background_equal_the_reference) {
  constexpr Index width = 1710, height = 620;
  std::mt19937 random(3);
  const auto pixels = random_pixels(width * height, 20'000, random);
  const ConstImageView image(pixels.data(), width, height);
  Numbers expected(pixels.size());
  reference::squared_distances(image, {expected.data(), width, height});
  std::vector<double> roots;
  for (const std::int32_t square : expected) roots.push_back(std::sqrt(square));
  for (const auto& variant : detail::study::distance_operation().variants) {
    if (!unavailable_reason(variant, width).empty()) continue;
    const auto state = make_state(variant, width, height, {}, 3);
    Numbers found(expected.size() + 1);
    state->run(image, {found.data() + 1, width, height});
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), found.begin() + 1))
        << name_of(variant);
    std::vector<double> found_roots(expected.size());
    state->run(image, {found_roots.data(), width, height}, {});
    EXPECT_TRUE(found_roots == roots) << name_of(variant);
  }
}

TEST(SquaredDistances, are_exact_at_the_greatest_distance) {
  std::vector<std::uint8_t> pixels(kMaxDistanceSide, 1);
  pixels.front() = 0;
  const auto square = [](Index a) { return static_cast<std::int32_t>(a * a); };
  for (const bool is_row : {true, false}) {
    const Index width = is_row ? kMaxDistanceSide : 1;
    const Numbers found = distances_of({pixels.data(), width, kMaxDistanceSide / width});
    EXPECT_EQ(found.back(), square(kMaxDistanceSide - 1));
    EXPECT_EQ(found[1000], square(1000));
  }
}

TEST(SquaredDistances, know_no_background_in_the_longest_column) {
  const std::vector<std::uint8_t> pixels(kMaxDistanceSide, 1);
  const Numbers found = distances_of({pixels.data(), 1, kMaxDistanceSide});
  EXPECT_EQ(found, Numbers(pixels.size(), kNoBackground));
}

TEST(SquaredDistances, leave_gaps_between_rows_alone) {
  const ByteImage image = image_of({"#.", "##"});
  Numbers numbers(10, -1);
  squared_distances(image.view(), {numbers.data(), 2, 2, 5});
  EXPECT_EQ(numbers, (Numbers{1, 0, -1, -1, -1, 2, 1, -1, -1, -1}));
}

TEST(SquaredDistances, are_written_beside_the_image_in_one_buffer) {
  std::array<std::int32_t, 6> both{};  // two rows: two pixels in four bytes, then two distances
  auto* const pixels = reinterpret_cast<std::uint8_t*>(both.data());
  std::fill_n(pixels, 2, std::uint8_t{1});
  squared_distances({pixels, 2, 2, 12}, {both.data() + 1, 2, 2, 3});
  EXPECT_EQ(std::vector(both.begin() + 1, both.begin() + 3), (Numbers{1, 1}));
  EXPECT_EQ(std::vector(both.begin() + 4, both.end()), (Numbers{0, 0}));
}

std::vector<double> distances_with(const Spacing& spacing, const ConstImageView& image,
                                   const Execution& execution = {}) {
  std::vector<double> found(static_cast<std::size_t>(image.width * image.height), -1);
  distances(image, {found.data(), image.width, image.height}, spacing, execution);
  return found;
}

TEST(Distances, of_a_small_image_are_as_worked_by_hand) {
  const ByteImage image = image_of({"###",  //
                                    "##.",  //
                                    "###"});
  EXPECT_EQ(distances_with({.x = 4, .y = 3}, image.view()),
            (std::vector<double>{std::sqrt(9.0 + 64), 5, 3, 8, 4, 0, std::sqrt(9.0 + 64), 5, 3}));
}

TEST(Distances, equal_the_formula_for_every_spacing_and_isa) {
  std::mt19937 random(2);
  constexpr std::array<Spacing, 6> spacings = {
      {{1, 1}, {0.1, 0.1}, {2, 3}, {0.37, 0.11}, {1e-9, 1e9}, {1e30, 1e-30}}};
  for (int i = 0; i < 600; ++i) {
    const Index width = 1 + static_cast<Index>(random() % 40);
    const Index height = 1 + static_cast<Index>(random() % 20);
    const auto pixels = random_pixels(width * height, i % 3 == 0 ? 300 : 2 + i % 20, random);
    const ConstImageView image(pixels.data(), width, height);
    const Spacing spacing = spacings[random() % spacings.size()];
    std::vector<double> expected(pixels.size());
    reference::distances(image, {expected.data(), width, height}, spacing);
    for (const auto& variant : detail::distance_operation().variants) {
      if (!isa_available(variant.isa)) continue;
      const auto found = distances_with(spacing, image, {.isa = variant.isa});
      for (std::size_t p = 0; p < found.size(); ++p) {
        ASSERT_DOUBLE_EQ(found[p], expected[p])
            << spacing.x << ", " << spacing.y << ", image " << i;
      }
    }
  }
}

TEST(Distances, without_background_are_infinite) {
  const std::vector<std::uint8_t> pixels(40, 1);
  const std::vector<double> infinite(40, std::numeric_limits<double>::infinity());
  EXPECT_EQ(distances_with({}, {pixels.data(), 40, 1}), infinite);
  EXPECT_EQ(distances_with({2, 1}, {pixels.data(), 5, 8}), infinite);
}

}  // namespace
}  // namespace thinbench
