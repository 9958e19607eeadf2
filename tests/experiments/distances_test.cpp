// Distances and the ridge of their map against the definitions, pixel by pixel.
#include "experiments/distances.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <gtest/gtest.h>

#include "experiments/skeleton_measures.hpp"
#include "harness/test_images.hpp"

namespace thinbench {
namespace {

/// The definition, as plainly as it can be put: every marked pixel is asked.
std::int64_t nearest_marked(const ByteImage& marked, Index x, Index y) {
  std::int64_t best = kNoBackground;
  for (Index row = 0; row < marked.height(); ++row) {
    for (Index column = 0; column < marked.width(); ++column) {
      if (marked.at(column, row) == 0) continue;
      best = std::min(best, (x - column) * (x - column) + (y - row) * (y - row));
    }
  }
  return best;
}

void expect_exact_distances(const ByteImage& marked) {
  const Distances found(marked.view());
  for (Index y = 0; y < marked.height(); ++y) {
    for (Index x = 0; x < marked.width(); ++x) {
      ASSERT_EQ(found.squared(x, y), nearest_marked(marked, x, y))
          << x << ", " << y << " of " << marked.width() << " x " << marked.height();
    }
  }
}

TEST(Distances, are_those_to_the_nearest_of_all_marked_pixels) {
  std::uint64_t seed = 900;
  for (const int percent : {0, 1, 3, 10, 50, 90, 100}) {
    for (const auto& [width, height] :
         {std::pair<Index, Index>{1, 1}, {1, 23}, {29, 1}, {7, 5}, {31, 17}, {16, 40}}) {
      for (const Index granularity : {1, 3}) {
        expect_exact_distances(noise_image(width, height, percent, granularity, ++seed));
      }
    }
  }
}

TEST(Distances, of_one_marked_pixel_are_circles_round_it) {
  for (const Index place : {0, 4, 10}) {
    ByteImage marked(11, 11);
    marked.at(place, 10 - place) = 1;
    expect_exact_distances(marked);
  }
}

/// 255 where no pixel up to three rows and columns away is further from light by 0.8 a pixel of
/// way; light are light pixels and all outside.
ByteImage axis_by_definition(const ByteImage& image) {
  ByteImage light(image.width() + 14, image.height() + 14);
  for (Index y = 0; y < light.height(); ++y) {
    for (Index x = 0; x < light.width(); ++x) {
      const Index ix = x - 7;
      const Index iy = y - 7;
      const bool inside = ix >= 0 && iy >= 0 && ix < image.width() && iy < image.height();
      light.at(x, y) = inside && image.at(ix, iy) != 0 ? 0 : 1;
    }
  }
  const auto distance = [&](Index x, Index y) {
    return std::sqrt(static_cast<double>(nearest_marked(light, x + 7, y + 7)));
  };
  ByteImage axis(image.width(), image.height());
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      bool steep = image.at(x, y) == 0;
      for (Index dy = -3; dy <= 3; ++dy) {
        for (Index dx = -3; dx <= 3; ++dx) {
          const double way = std::hypot(dx, dy);
          steep = steep || (way > 0 && distance(x + dx, y + dy) - distance(x, y) >= 0.8 * way);
        }
      }
      axis.at(x, y) = steep ? 0 : 255;
    }
  }
  return axis;
}

TEST(SkeletonMeasures, axis_is_where_the_distance_to_light_and_to_the_outside_rises_nowhere) {
  std::uint64_t seed = 950;
  for (const int percent : {60, 90, 100}) {
    const ByteImage image = noise_image(19, 14, percent, 4, ++seed);
    EXPECT_TRUE(equal(medial_axis_of(image.view()).view(), axis_by_definition(image).view()))
        << percent;
  }
}

}  // namespace
}  // namespace thinbench
