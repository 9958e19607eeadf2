// Images made by a function of their places, of other images' pixels, or by thinning.
#pragma once

#include <algorithm>
#include <cstdint>

#include "support/byte_image.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {

/// Pixel (x, y) is of(x, y).
template <class Of>
ByteImage image_by(Index width, Index height, const Of& of) {
  ByteImage image(width, height);
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) image.at(x, y) = static_cast<std::uint8_t>(of(x, y));
  }
  return image;
}

/// Pixels that are of(pixel).
template <class Of>
ByteImage mapped(const ByteImage& image, const Of& of) {
  return image_by(image.width(), image.height(),
                  [&](Index x, Index y) { return of(image.at(x, y)); });
}

inline Index count_foreground(const ByteImage& image) {
  Index count = 0;
  for (Index y = 0; y < image.height(); ++y) {
    const std::uint8_t* row = image.view().row(y);
    count += image.width() - std::count(row, row + image.width(), std::uint8_t{0});
  }
  return count;
}

inline ByteImage thinned(const Rule& rule, const ByteImage& image, const Thinning& thinning = {}) {
  ByteImage result(image.width(), image.height());
  thin(rule, image.view(), result.view(), thinning);
  return result;
}

}  // namespace thinbench
