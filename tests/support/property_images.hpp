// Images on which the properties of skeletons are tested, and what is counted in them.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/test_images.hpp"
#include "holes.hpp"
#include "scene/scene.hpp"

namespace thinbench {

/// Noise of several densities and block sizes, and both scenes.
inline std::vector<ByteImage> property_images() {
  std::vector<ByteImage> images;
  std::uint64_t seed = 500;
  for (const int percent : {30, 50, 70, 90, 97}) {
    for (const Index granularity : {1, 2, 3, 5, 8}) {
      images.push_back(noise_image(131, 77, percent, granularity, ++seed));
    }
  }
  images.push_back(std::move(render_scene().binary));
  images.push_back(std::move(render_scene({SceneKind::border_touching}).binary));
  return images;
}

struct RegionCounts {
  std::size_t objects;
  std::size_t holes;

  friend bool operator==(const RegionCounts&, const RegionCounts&) = default;
};

/// By the reference.
inline RegionCounts region_counts(const ByteImage& image) {
  const reference::Regions found = reference::holes(image.view());
  return {found.objects.size(), found.holes.size()};
}

/// The number of foreground pixels of `skeleton` that are background in `image`.
inline Index pixels_outside(const ByteImage& skeleton, const ByteImage& image) {
  Index outside = 0;
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      outside += skeleton.at(x, y) != 0 && image.at(x, y) == 0 ? 1 : 0;
    }
  }
  return outside;
}

}  // namespace thinbench
