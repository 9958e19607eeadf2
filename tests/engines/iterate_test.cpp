// Which parts of an image are visited again, and the engine on tiles.
#include "engines/iterate.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/packing.hpp"
#include "engines/iterate_tiles.hpp"
#include "harness/test_images.hpp"
#include "support/made_image.hpp"
#include "support/reference_thinning.hpp"
#include "support/variant_of.hpp"

namespace thinbench::detail {
namespace {

constexpr Index kRows = BandActivity::kRows;

/// Visits the active cells; `changes(band)` has a bit for every column that changes.
template <class Changes>
std::vector<std::pair<Index, std::uint64_t>> visit(BandActivity& activity, int lookback,
                                                   const Changes& changes) {
  std::vector<std::pair<Index, std::uint64_t>> visited;
  const auto bands = activity.begin_sub_iteration(lookback);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const Index band = bands[i].first / kRows;
    visited.emplace_back(band, bands[i].columns);
    activity.set_changed(i, changes(band) & bands[i].columns);
  }
  activity.end_sub_iteration();
  return visited;
}

constexpr auto kNothing = [](Index) { return std::uint64_t{0}; };
using Visits = std::vector<std::pair<Index, std::uint64_t>>;

TEST(BandActivity, first_two_sub_iterations_visit_every_cell) {
  BandActivity activity({0, 3 * kRows - 5}, 6, 1);
  for (int repeat = 0; repeat < 2; ++repeat) {
    activity.restart();
    const Visits everything = {{0, 0b111111}, {1, 0b111111}, {2, 0b111111}};
    EXPECT_EQ(visit(activity, 1, kNothing), everything);
    EXPECT_EQ(visit(activity, 1, kNothing), everything);
    EXPECT_TRUE(visit(activity, 1, kNothing).empty());
  }
}

TEST(BandActivity, has_at_most_64_columns_of_equal_width) {
  const std::pair<Index, int> kColumns[] = {{1, 1}, {63, 63}, {64, 64}, {65, 33}, {128, 64}};
  for (const auto& [elements, columns] : kColumns) {
    BandActivity activity({0, kRows}, elements, 1);
    activity.restart();
    const Visits all = {{0, ~std::uint64_t{0} >> (64 - columns)}};
    EXPECT_EQ(visit(activity, 1, kNothing), all) << elements;
  }
}

TEST(BandActivity, change_activates_the_cell_and_its_eight_neighbours_for_one_sub_iteration) {
  BandActivity activity({0, 6 * kRows}, 6, 1);
  activity.restart();
  visit(activity, 1, kNothing);
  visit(activity, 1, [](Index band) { return std::uint64_t{band == 3 ? 0b001000U : 0U}; });
  EXPECT_EQ(visit(activity, 1, kNothing), (Visits{{2, 0b011100}, {3, 0b011100}, {4, 0b011100}}));
  EXPECT_TRUE(visit(activity, 1, kNothing).empty());
}

TEST(BandActivity, lookback_of_two_keeps_cells_active_for_two_sub_iterations) {
  BandActivity activity({0, 6 * kRows}, 2, 1);
  activity.restart();
  visit(activity, 2, kNothing);
  visit(activity, 2, kNothing);
  visit(activity, 2, [](Index band) { return std::uint64_t{band == 0 ? 1U : 0U}; });
  EXPECT_EQ(visit(activity, 2, kNothing), (Visits{{0, 0b11}, {1, 0b11}}));
  EXPECT_EQ(visit(activity, 2, kNothing), (Visits{{0, 0b11}, {1, 0b11}}));
  EXPECT_TRUE(visit(activity, 2, kNothing).empty());
}

/// Thins by tiles; returns the number of iterations.
int thin_by_tiles(BuiltInRule rule, const ByteImage& image, ByteImage& skeleton, int threads = 1,
                  Border border = Border::background) {
  return thin_by("simd_bitpacked_tiles", rule, image.view(), skeleton.view(), {.border = border},
                 {.threads = threads});
}

/// A grid of squares of different sizes, so that tiles stop changing at different times.
ByteImage squares(Index width, Index height, Index side) {
  return image_by(width, height, [=](Index x, Index y) {
    const Index size = 2 + (x / side + 3 * (y / side)) % (side - 2);
    return x % side < size && y % side < size ? 255 : 0;
  });
}

/// Compares tiles with the reference for rules on 3 x 3 pixels, of two and of four sub-iterations,
/// and one on 5 x 5 pixels.
void expect_equal_to_reference(const ByteImage& image, int threads) {
  ByteImage by_tiles(image.width(), image.height());
  for (const BuiltInRule rule : {Rule::guo_hall, Rule::spta_directional, Rule::mb2}) {
    for (const Border border : {Border::background, Border::keep}) {
      const Thinned expected = thinned_by_reference(rule, image, {border});
      EXPECT_EQ(thin_by_tiles(rule, image, by_tiles, threads, border), expected.iterations);
      EXPECT_TRUE(equal(by_tiles.view(), expected.image.view()))
          << rule_name(rule) << ", border " << border_name(border) << ", threads " << threads;
    }
  }
}

TEST(IterateTiles, equals_the_reference) {
  // Tiles are written during the scan.
  for (const Index side : {7, 40, 130}) expect_equal_to_reference(squares(1000, 400, side), 1);
  // A chunk ends at a gap within a row: rows of 125 tiles, more than 1,024 in ten of them.
  ByteImage image = squares(4000, 300, 24);
  for (Index y = 0; y < image.height(); ++y)
    std::fill_n(image.view().row(y) + 1900, 400, std::uint8_t{0});
  expect_equal_to_reference(image, 1);
  // A row of tiles is longer than a word, and longer than a chunk.
  expect_equal_to_reference(squares(4500, 300, 64), 1);
  expect_equal_to_reference(squares(40000, 70, 26), 1);
}

TEST(IterateTiles, equals_the_reference_on_several_threads) {
  // More than 7 x 256 tiles are enough for 7 threads; with fewer one works alone.
  for (const int threads : {2, 7}) expect_equal_to_reference(squares(2000, 2400, 24), threads);
  expect_equal_to_reference(noise_image(64, 16000, 88, 1, 3), 7);
}

/// They are not prefetched.
TEST(IterateTiles, equals_the_reference_with_long_gaps_between_rows) {
  constexpr Index width = 2000, height = 600;
  ByteImage surrounding = filled_image(3 * width, height, 255);
  ImageView source = surrounding.view();
  source.width = width;
  const ByteImage image = squares(width, height, 24);
  for (Index y = 0; y < height; ++y) std::copy_n(image.view().row(y), width, source.row(y));
  ByteImage by_tiles(width, height);
  thin_by("simd_bitpacked_tiles", Rule::guo_hall, source, by_tiles.view(), {}, {.threads = 1});
  const Thinned expected = thinned_by_reference(Rule::guo_hall, image, {});
  EXPECT_TRUE(equal(by_tiles.view(), expected.image.view()));
}

TEST(IterateTiles, non_temporal_stores_write_the_same_pixels) {
  const Index width = 4100;  // the last word of a row is partial
  const Index height = 2113;
  const ByteImage image = squares(width, height, 24);
  ASSERT_GE(width * height, kNonTemporalBytes);
  ByteImage by_words(width, height);
  thin_by("simd_bitpacked", Rule::zhang_suen, image.view(), by_words.view());
  for (const int threads : {1, 3}) {
    ByteImage in_place = copy_of(image.view());
    thin_by_tiles(Rule::zhang_suen, in_place, in_place, threads);
    EXPECT_TRUE(equal(in_place.view(), by_words.view())) << threads << " threads";
  }
}

}  // namespace
}  // namespace thinbench::detail
