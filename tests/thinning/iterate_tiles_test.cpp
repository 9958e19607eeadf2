#include "thinning/iteration/iterate_tiles.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "dispatch/exported.hpp"
#include "image/packing.hpp"
#include "reference.hpp"
#include "support/splitmix64.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench::detail {
namespace {

/// Runs a rule by tiles; the number of iterations.
int thin_by_tiles(Rule rule, const ByteImage& image, ByteImage& skeleton, int threads = 1,
                  Border border = Border::background) {
  return thin(rule, image.view(), skeleton.view(),
              {.border = border, .threads = threads, .technique = Technique::simd_bitpacked_tiles});
}

/// Squares on a raster, so that tiles stop changing at different times.
ByteImage squares(Index width, Index height, Index side) {
  ByteImage image(width, height);
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) {
      const Index size = 2 + (x / side + 3 * (y / side)) % (side - 2);
      image.at(x, y) = x % side < size && y % side < size ? 255 : 0;
    }
  }
  return image;
}

/// Whether tiles give what the reference gives, on so many threads, where a rule looks one pixel
/// far and where it looks two.
void expect_as_reference(const ByteImage& image, int threads) {
  ByteImage by_tiles(image.width(), image.height());
  ByteImage by_reference(image.width(), image.height());
  for (const Rule rule : {Rule::guo_hall, Rule::mb2}) {
    for (const Border border : {Border::background, Border::keep}) {
      const int iterations = thin_by_tiles(rule, image, by_tiles, threads, border);
      EXPECT_EQ(iterations, reference::thinning(rule)({border}, image.view(), by_reference.view()));
      EXPECT_TRUE(equal(by_tiles.view(), by_reference.view()))
          << rule_name(rule) << ", border " << border_name(border) << ", threads " << threads;
    }
  }
}

TEST(IterateTiles, equals_the_reference_where_tiles_are_written_on_the_way) {
  for (const Index side : {7, 40, 130}) expect_as_reference(squares(1000, 400, side), 1);
}

TEST(IterateTiles, equals_the_reference_where_fewer_wait_from_step_to_step) {
  expect_as_reference(squares(200, 2500, 30), 1);  // strips of 157 tiles: room is searched for
}

TEST(IterateTiles, threads_equal_the_reference) {
  const ByteImage image = squares(2000, 2400, 24);  // more than 7 x 512 tiles, so that 7 share
  for (const int threads : {2, 7}) expect_as_reference(image, threads);
}

TEST(IterateTiles, one_of_many_threads_has_room_to_work_alone) {
  // 4,012 tiles and their margins are enough for 7 threads, the 2,000 with foreground are not.
  ByteImage image(64, 16000);
  std::uint64_t index = 0;
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x)
      image.at(x, y) = splitmix64(3, index++) % 8 != 0 ? 255 : 0;
  }
  expect_as_reference(image, 7);
}

TEST(IterateTiles, rows_written_by_non_temporal_stores_are_the_same) {
  const Index width = 4100;  // the last word of a row is not full
  const Index height = 2113;
  const ByteImage image = squares(width, height, 24);
  ASSERT_GE(width * height, kNonTemporalBytes);
  ByteImage by_words(width, height);
  thin(Rule::zhang_suen, image.view(), by_words.view(), {.technique = Technique::simd_bitpacked});
  for (const int threads : {1, 3}) {
    ByteImage in_place = copy_of(image.view());
    thin_by_tiles(Rule::zhang_suen, in_place, in_place, threads);
    EXPECT_TRUE(equal(in_place.view(), by_words.view())) << threads << " threads";
  }
}

/// Whether entries `apart` places from each other differ by `reach` or more.
bool lie_apart(const std::vector<std::uint32_t>& tiles, std::size_t apart, std::uint32_t reach) {
  for (std::size_t i = 0; i + apart < tiles.size(); ++i) {
    if (tiles[i + apart] - tiles[i] < reach) return false;
  }
  return true;
}

/// Ascending, with gaps of up to `largest_gap`.
std::vector<std::uint32_t> tiles_with_gaps(std::size_t count, std::uint64_t largest_gap) {
  std::vector<std::uint32_t> tiles;
  std::uint32_t tile = 0;
  while (tiles.size() < count) {
    const std::uint64_t random = splitmix64(7, largest_gap << 32 | tiles.size());
    tile += 1 + static_cast<std::uint32_t>(random % largest_gap);
    tiles.push_back(tile);
  }
  return tiles;
}

void expect_enough_and_few(FindDelay find_delay, const std::vector<std::uint32_t>& tiles,
                           std::uint32_t reach) {
  const auto count = static_cast<Index>(tiles.size());
  for (const Index guess : {1, 50, 1000}) {
    const Index delay = find_delay(tiles.data(), count, reach, guess, static_cast<Index>(reach));
    EXPECT_LE(delay, reach);
    EXPECT_TRUE(lie_apart(tiles, static_cast<std::size_t>(delay), reach));
    const Index fewer = delay - delay / 8 - 1;
    EXPECT_TRUE(fewer < 32 || !lie_apart(tiles, static_cast<std::size_t>(fewer), reach));
  }
}

TEST(FindDelay, is_enough_and_not_much_more) {
  for (const Isa isa : kAllIsas) {
    if (!isa_available(isa)) continue;
    for (const std::uint32_t reach : {70U, 261U}) {
      for (const std::size_t count : {0U, 1U, 30U, 400U, 3000U}) {
        for (const std::uint64_t largest_gap : {1U, 3U, 40U}) {
          expect_enough_and_few(kernels_of<TileKernels>(isa).find_delay,
                                tiles_with_gaps(count, largest_gap), reach);
        }
      }
    }
  }
}

TEST(IterateTiles, groups_beyond_the_first_word_are_found) {
  const ByteImage image = squares(4500, 300, 64);  // more than 64 groups of tiles
  ByteImage by_tiles(4500, 300);
  ByteImage by_reference(4500, 300);
  thin_by_tiles(Rule::zhang_suen, image, by_tiles);
  reference::thinning(Rule::zhang_suen)({}, image.view(), by_reference.view());
  EXPECT_TRUE(equal(by_tiles.view(), by_reference.view()));
}

TEST(IterateTiles, threads_that_share_a_step_give_the_same) {
  const ByteImage image = squares(2000, 1200, 90);
  ByteImage one(2000, 1200);
  ByteImage many(2000, 1200);
  for (const int threads : {2, 3, 7}) {
    const int iterations = thin_by_tiles(Rule::spta_directional, image, one);
    EXPECT_EQ(iterations, thin_by_tiles(Rule::spta_directional, image, many, threads));
    EXPECT_TRUE(equal(one.view(), many.view())) << threads << " threads";
  }
}

TEST(IterateTiles, an_image_without_foreground_takes_one_iteration) {
  const ByteImage background(70, 70);
  ByteImage result(70, 70);
  EXPECT_EQ(thin_by_tiles(Rule::guo_hall, background, result), 1);
  EXPECT_TRUE(equal(background.view(), result.view()));
}

}  // namespace
}  // namespace thinbench::detail
