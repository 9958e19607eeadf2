// Images of any size on which thinning engines are likely to fail.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/test_images.hpp"
#include "support/filled_image.hpp"
#include "support/made_image.hpp"

namespace thinbench::edge_case_images {

/// Bars three pixels thick along all four sides, with gaps, and lines from side to side.
inline ByteImage shapes_on_every_side(Index width, Index height) {
  return image_by(width, height, [=](Index x, Index y) {
    const bool bar = x < 3 || y < 3 || x >= width - 3 || y >= height - 3;
    const bool gap = (x + 2 * y) % 11 < 2;
    const bool line = x % 29 == 7 || y % 13 == 5 || (x + y) % 31 < 2;
    return (bar && !gap) || line ? 255 : 0;
  });
}

/// Noise, all foreground, shapes, and noise again, so that consecutive images have both more and
/// less foreground than the one before.
inline std::vector<ByteImage> of_size(Index width, Index height, std::uint64_t seed) {
  std::vector<ByteImage> images;
  images.push_back(noise_image(width, height, 60, 1, seed));
  images.push_back(filled_image(width, height, 255));
  images.push_back(shapes_on_every_side(width, height));
  images.push_back(noise_image(width, height, 93, 2, seed + 1));
  return images;
}

}  // namespace thinbench::edge_case_images
