#include "experiments/skeleton_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/distances.hpp"
#include "holes.hpp"

namespace thinbench {
namespace {

constexpr double kSteep = 0.8;
constexpr Index kReach = 3;

/// With background pixels all round, so that the outside is seen.
ByteImage padded(const ConstImageView& image) {
  ByteImage result(image.width + 2, image.height + 2);
  for (Index y = 0; y < image.height; ++y) {
    for (Index x = 0; x < image.width; ++x) result.at(x + 1, y + 1) = image.row(y)[x] != 0 ? 1 : 0;
  }
  return result;
}

/// The eight neighbours in order round a pixel of a padded image.
std::array<int, 8> ring_at(const ByteImage& image, Index x, Index y) {
  return {image.at(x + 1, y), image.at(x + 1, y - 1), image.at(x, y - 1), image.at(x - 1, y - 1),
          image.at(x - 1, y), image.at(x - 1, y + 1), image.at(x, y + 1), image.at(x + 1, y + 1)};
}

void add_pixel(SkeletonShape& shape, const std::array<int, 8>& ring) {
  int neighbours = 0;
  int steps = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    neighbours += ring[i];
    steps += ring[i] == 0 && ring[(i + 1) % ring.size()] != 0 ? 1 : 0;
  }
  shape.pixels += 1;
  shape.ends += neighbours == 1 ? 1 : 0;
  shape.branches += steps >= 3 ? 1 : 0;
  shape.blocks +=
      ring[0] != 0 && ring[6] != 0 && ring[7] != 0 ? 1 : 0;  // the pixel at its top left
}

/// Euclidean distances to the background, and 0 everywhere outside.
class DistanceMap {
 public:
  explicit DistanceMap(const ConstImageView& image)
      : width_(image.width), height_(image.height), to_background_(background_of(image).view()) {}

  [[nodiscard]] double at(Index x, Index y) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return 0;
    return std::sqrt(static_cast<double>(to_background_.squared(x + 1, y + 1)));
  }

 private:
  static ByteImage background_of(const ConstImageView& image) {
    const ByteImage all = padded(image);
    return image_by(all.width(), all.height(), [&](Index x, Index y) { return 1 - all.at(x, y); });
  }

  Index width_;
  Index height_;
  Distances to_background_;
};

bool rises_steeply(const DistanceMap& map, Index x, Index y) {
  const double here = map.at(x, y);
  for (Index dy = -kReach; dy <= kReach; ++dy) {
    for (Index dx = -kReach; dx <= kReach; ++dx) {
      if (dx == 0 && dy == 0) continue;
      const double way = std::sqrt(static_cast<double>(dx * dx + dy * dy));
      if (map.at(x + dx, y + dy) - here >= kSteep * way) return true;
    }
  }
  return false;
}

}  // namespace

Topology topology_of(const ConstImageView& image) {
  const reference::Regions found = reference::holes(image);
  return {static_cast<Index>(found.objects.size()), static_cast<Index>(found.holes.size())};
}

SkeletonShape shape_of(const ConstImageView& skeleton) {
  const ByteImage all = padded(skeleton);
  SkeletonShape shape;
  for (Index y = 1; y <= skeleton.height; ++y) {
    for (Index x = 1; x <= skeleton.width; ++x) {
      if (all.at(x, y) != 0) add_pixel(shape, ring_at(all, x, y));
    }
  }
  return shape;
}

ByteImage medial_axis_of(const ConstImageView& image) {
  const DistanceMap map(image);
  return image_by(image.width, image.height, [&](Index x, Index y) {
    return image.row(y)[x] != 0 && !rises_steeply(map, x, y) ? 255 : 0;
  });
}

AxisDistance distance_from(const ConstImageView& axis, const ConstImageView& skeleton) {
  const Distances to_axis(axis);
  AxisDistance distance;
  double pixels = 0;
  for (Index y = 0; y < skeleton.height; ++y) {
    for (Index x = 0; x < skeleton.width; ++x) {
      if (skeleton.row(y)[x] == 0) continue;
      const double one = std::sqrt(static_cast<double>(to_axis.squared(x, y)));
      pixels += 1;
      distance.mean += one;
      distance.largest = std::max(distance.largest, one);
    }
  }
  if (pixels > 0) distance.mean /= pixels;
  return distance;
}

double overlap(const ConstImageView& a, const ConstImageView& b) {
  double both = 0;
  double either = 0;
  for (Index y = 0; y < a.height; ++y) {
    for (Index x = 0; x < a.width; ++x) {
      both += a.row(y)[x] != 0 && b.row(y)[x] != 0 ? 1 : 0;
      either += a.row(y)[x] != 0 || b.row(y)[x] != 0 ? 1 : 0;
    }
  }
  return either > 0 ? both / either : 1;
}

ByteImage rotated_by_quarter(const ConstImageView& image) {
  return image_by(image.height, image.width,
                  [&](Index x, Index y) { return image.row(x)[image.width - 1 - y]; });
}

}  // namespace thinbench
