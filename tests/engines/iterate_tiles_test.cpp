#include "engines/iterate_tiles.hpp"

#include <gtest/gtest.h>

#include "core/packing.hpp"
#include "harness/splitmix64.hpp"
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
  ByteImage image(width, height);
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) {
      const Index size = 2 + (x / side + 3 * (y / side)) % (side - 2);
      image.at(x, y) = x % side < size && y % side < size ? 255 : 0;
    }
  }
  return image;
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
}

TEST(IterateTiles, equals_the_reference_if_a_chunk_ends_at_a_gap_within_a_row) {
  ByteImage image = squares(4000, 300, 24);  // rows of 125 tiles, more than 1,024 in ten of them
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 1900; x < 2300; ++x) image.at(x, y) = 0;
  }
  expect_equal_to_reference(image, 1);
}

TEST(IterateTiles, equals_the_reference_if_a_row_of_tiles_is_longer_than_a_chunk) {
  expect_equal_to_reference(squares(40000, 70, 26), 1);
}

TEST(IterateTiles, equals_the_reference_on_several_threads) {
  const ByteImage image = squares(2000, 2400, 24);  // more than 7 x 256 tiles, enough for 7 threads
  for (const int threads : {2, 7}) expect_equal_to_reference(image, threads);
}

TEST(IterateTiles, equals_the_reference_if_one_of_many_threads_works_alone) {
  // The tiles are too few for 7 threads.
  ByteImage image(64, 16000);
  std::uint64_t index = 0;
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x)
      image.at(x, y) = splitmix64(3, index++) % 8 != 0 ? 255 : 0;
  }
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

TEST(IterateTiles, equals_the_reference_with_several_words_per_row_of_tiles) {
  const ByteImage image = squares(4500, 300, 64);
  ByteImage by_tiles(4500, 300);
  thin_by_tiles(Rule::zhang_suen, image, by_tiles);
  const Thinned expected = thinned_by_reference(Rule::zhang_suen, image);
  EXPECT_TRUE(equal(by_tiles.view(), expected.image.view()));
}

TEST(IterateTiles, several_threads_equal_one_for_a_rule_with_four_sub_iterations) {
  const ByteImage image = squares(2000, 1200, 90);
  ByteImage one(2000, 1200);
  ByteImage many(2000, 1200);
  for (const int threads : {2, 3, 7}) {
    const int iterations = thin_by_tiles(Rule::spta_directional, image, one);
    EXPECT_EQ(iterations, thin_by_tiles(Rule::spta_directional, image, many, threads));
    EXPECT_TRUE(equal(one.view(), many.view())) << threads << " threads";
  }
}

TEST(IterateTiles, image_without_foreground_takes_one_iteration) {
  const ByteImage background(70, 70);
  ByteImage result(70, 70);
  EXPECT_EQ(thin_by_tiles(Rule::guo_hall, background, result), 1);
  EXPECT_TRUE(equal(background.view(), result.view()));
}

}  // namespace
}  // namespace thinbench::detail
