#include "engines/iterate_tiles.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "core/exported.hpp"
#include "core/packing.hpp"
#include "harness/splitmix64.hpp"
#include "support/made_image.hpp"
#include "support/reference_thinning.hpp"
#include "support/variant_of.hpp"

namespace thinbench::detail {
namespace {

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

/// Compares tiles with the reference for a rule on 3 x 3 pixels and one on 5 x 5 pixels.
void expect_equal_to_reference(const ByteImage& image, int threads) {
  ByteImage by_tiles(image.width(), image.height());
  for (const BuiltInRule rule : {Rule::guo_hall, Rule::mb2}) {
    for (const Border border : {Border::background, Border::keep}) {
      const Thinned expected = thinned_by_reference(rule, image, {border});
      EXPECT_EQ(thin_by_tiles(rule, image, by_tiles, threads, border), expected.iterations);
      EXPECT_TRUE(equal(by_tiles.view(), expected.image.view()))
          << rule_name(rule) << ", border " << border_name(border) << ", threads " << threads;
    }
  }
}

TEST(IterateTiles, equals_the_reference_if_tiles_are_written_during_the_scan) {
  for (const Index side : {7, 40, 130}) expect_equal_to_reference(squares(1000, 400, side), 1);
  expect_equal_to_reference(squares(4500, 300, 64), 1);  // more than 64 groups of tiles
  // Strips of 157 tiles, so that find_delay is called.
  expect_equal_to_reference(squares(200, 2500, 30), 1);
}

TEST(IterateTiles, equals_the_reference_on_several_threads) {
  const ByteImage image = squares(2000, 2400, 24);  // more than 7 x 512 tiles, enough for 7 threads
  for (const int threads : {2, 7}) expect_equal_to_reference(image, threads);
}

TEST(IterateTiles, equals_the_reference_if_one_of_many_threads_works_alone) {
  // 4,012 tiles with their margins are enough for 7 threads, but the 2,000 with foreground are not.
  std::uint64_t index = 0;
  const ByteImage image =
      image_by(64, 16000, [&](Index, Index) { return splitmix64(3, index++) % 8 != 0 ? 255 : 0; });
  expect_equal_to_reference(image, 7);
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

/// Whether tiles[i + distance] - tiles[i] >= reach for all i.
bool all_gaps_reach(const std::vector<std::uint32_t>& tiles, std::size_t distance,
                    std::uint32_t reach) {
  for (std::size_t i = 0; i + distance < tiles.size(); ++i) {
    if (tiles[i + distance] - tiles[i] < reach) return false;
  }
  return true;
}

/// An ascending list with gaps of 1 to `max_gap`.
std::vector<std::uint32_t> tiles_with_gaps(std::size_t count, std::uint64_t max_gap) {
  std::vector<std::uint32_t> tiles;
  std::uint32_t tile = 0;
  while (tiles.size() < count) {
    const std::uint64_t random = splitmix64(7, max_gap << 32 | tiles.size());
    tile += 1 + static_cast<std::uint32_t>(random % max_gap);
    tiles.push_back(tile);
  }
  return tiles;
}

/// Checks that the delay suffices and that one about an eighth smaller would not.
void expect_near_minimum(FindDelay find_delay, const std::vector<std::uint32_t>& tiles,
                         std::uint32_t reach) {
  const auto count = static_cast<Index>(tiles.size());
  for (const Index guess : {1, 50, 1000}) {
    const Index delay = find_delay(tiles.data(), count, reach, guess, static_cast<Index>(reach));
    EXPECT_LE(delay, reach);
    EXPECT_TRUE(all_gaps_reach(tiles, static_cast<std::size_t>(delay), reach));
    const Index fewer = delay - delay / 8 - 1;
    EXPECT_TRUE(fewer < 32 || !all_gaps_reach(tiles, static_cast<std::size_t>(fewer), reach));
  }
}

TEST(FindDelay, result_suffices_and_is_close_to_the_minimum) {
  for (const Isa isa : all_isas()) {
    if (!isa_available(isa)) continue;
    for (const std::uint32_t reach : {70U, 261U}) {
      for (const std::size_t count : {0U, 1U, 30U, 400U, 3000U}) {
        for (const std::uint64_t max_gap : {1U, 3U, 40U}) {
          expect_near_minimum(kernels_of<TileKernels>(isa).find_delay,
                              tiles_with_gaps(count, max_gap), reach);
        }
      }
    }
  }
}

}  // namespace
}  // namespace thinbench::detail
