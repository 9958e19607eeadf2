// Images made of other images' pixels or by thinning.
#pragma once

#include <algorithm>
#include <cstdint>

#include "support/byte_image.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {

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
