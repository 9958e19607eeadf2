// Images whose pixels all have one value.
#pragma once

#include <algorithm>
#include <cstdint>

#include "support/byte_image.hpp"

namespace thinbench {

inline void fill(const ImageView& view, std::uint8_t value) {
  for (Index y = 0; y < view.height; ++y) std::fill_n(view.row(y), view.width, value);
}

inline ByteImage filled_image(Index width, Index height, std::uint8_t value) {
  ByteImage image(width, height);
  fill(image.view(), value);
  return image;
}

inline bool is_filled(const ConstImageView& view, std::uint8_t value) {
  for (Index y = 0; y < view.height; ++y) {
    const std::uint8_t* row = view.row(y);
    if (!std::all_of(row, row + view.width, [=](std::uint8_t pixel) { return pixel == value; })) {
      return false;
    }
  }
  return true;
}

}  // namespace thinbench
