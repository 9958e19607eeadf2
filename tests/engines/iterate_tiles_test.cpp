#include "engines/iterate_tiles.hpp"

#include <gtest/gtest.h>

#include "core/packing.hpp"
#include "harness/test_images.hpp"
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
}

TEST(IterateTiles, equals_the_reference_if_a_chunk_ends_at_a_gap_within_a_row) {
  ByteImage image = squares(4000, 300, 24);  // rows of 125 tiles, more than 1,024 in ten of them
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 1900; x < 2300; ++x) image.at(x, y) = 0;
  }
  expect_equal_to_reference(image, 1);
}

TEST(IterateTiles, equals_the_reference_if_a_row_of_tiles_is_longer_than_a_word_or_a_chunk) {
  expect_equal_to_reference(squares(4500, 300, 64), 1);  // several words of tiles per row
  expect_equal_to_reference(squares(40000, 70, 26), 1);
}

TEST(IterateTiles, equals_the_reference_on_several_threads) {
  const ByteImage image = squares(2000, 2400, 24);  // more than 7 x 256 tiles, enough for 7 threads
  for (const int threads : {2, 7}) expect_equal_to_reference(image, threads);
}

TEST(IterateTiles, equals_the_reference_if_one_of_many_threads_works_alone) {
  expect_equal_to_reference(noise_image(64, 16000, 88, 1, 3), 7);  // too few tiles for 7 threads
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

}  // namespace
}  // namespace thinbench::detail
