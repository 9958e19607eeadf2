// The library's own image owner, under a short name: inputs and outputs of benchmarks and tests.
#pragma once

#include "core/byte_image.hpp"

namespace thinbench {

using detail::ByteImage;
using detail::copy_of;
using detail::equal;

/// Pixel (x, y) is of(x, y).
template <class Of>
[[nodiscard]] ByteImage image_by(Index width, Index height, const Of& of) {
  ByteImage image(width, height);
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) image.at(x, y) = static_cast<std::uint8_t>(of(x, y));
  }
  return image;
}

}  // namespace thinbench
