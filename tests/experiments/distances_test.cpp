// The ridge of the map of distances against the definition, pixel by pixel.
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "experiments/skeleton_measures.hpp"
#include "harness/test_images.hpp"
#include "reference.hpp"
#include "support/made_image.hpp"

namespace thinbench {
namespace {

/// 255 where no pixel up to three rows and columns away is further from background by 0.8 per pixel
/// of way; all outside is background.
ByteImage axis_by_definition(const ByteImage& image) {
  constexpr Index margin = 7;
  const ByteImage padded =
      image_by(image.width() + 2 * margin, image.height() + 2 * margin, [&](Index x, Index y) {
        const Index u = x - margin, v = y - margin;
        const bool inside = u >= 0 && v >= 0 && u < image.width() && v < image.height();
        return inside ? image.at(u, v) : 0;
      });
  std::vector<std::int32_t> squares(static_cast<std::size_t>(padded.width() * padded.height()));
  const LabelView view = {squares.data(), padded.width(), padded.height()};
  reference::squared_distances(padded.view(), view);
  const auto distance = [&](Index x, Index y) {
    return std::sqrt(static_cast<double>(view.row(y + margin)[x + margin]));
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

TEST(SkeletonMeasures, axis_is_where_the_distance_to_background_and_to_the_outside_rises_nowhere) {
  std::uint64_t seed = 950;
  for (const int percent : {60, 90, 100}) {
    const ByteImage image = noise_image(19, 14, percent, 4, ++seed);
    EXPECT_TRUE(equal(medial_axis_of(image.view()).view(), axis_by_definition(image).view()))
        << percent;
  }
}

}  // namespace
}  // namespace thinbench
