// The ridge of the map of distances against the definition, pixel by pixel.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "experiments/skeleton_measures.hpp"
#include "harness/test_images.hpp"
#include "support/made_image.hpp"
#include "thinbench/distance.hpp"

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

/// 255 where no pixel up to three rows and columns away is further from light by 0.8 a pixel of
/// way; light are light pixels and all outside.
ByteImage axis_by_definition(const ByteImage& image) {
  const ByteImage light =
      image_by(image.width() + 14, image.height() + 14, [&](Index light_x, Index light_y) {
        const Index x = light_x - 7, y = light_y - 7;
        const bool inside = x >= 0 && y >= 0 && x < image.width() && y < image.height();
        return inside && image.at(x, y) != 0 ? 0 : 1;
      });
  const auto distance = [&](Index x, Index y) {
    return std::sqrt(static_cast<double>(nearest_marked(light, x + 7, y + 7)));
  };
  return image_by(image.width(), image.height(), [&](Index x, Index y) {
    bool steep = image.at(x, y) == 0;
    for (Index dy = -3; dy <= 3; ++dy) {
      for (Index dx = -3; dx <= 3; ++dx) {
        const double way = std::hypot(dx, dy);
        steep = steep || (way > 0 && distance(x + dx, y + dy) - distance(x, y) >= 0.8 * way);
      }
    }
    return steep ? 0 : 255;
  });
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
