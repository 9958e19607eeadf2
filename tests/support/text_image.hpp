// Binary images as text: '#' is foreground, '.' is background; all lines have the same length.
#pragma once

#include <string>
#include <vector>

#include "support/byte_image.hpp"

namespace thinbench {

using TextImage = std::vector<std::string>;

inline ByteImage image_of(const TextImage& lines) {
  ByteImage image(static_cast<Index>(lines.front().size()), static_cast<Index>(lines.size()));
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      const char pixel = lines[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      image.at(x, y) = pixel == '#' ? 255 : 0;
    }
  }
  return image;
}

/// The inverse; '?' for a pixel that is neither 0 nor 255.
inline TextImage text_of(const ByteImage& image) {
  TextImage lines;
  for (Index y = 0; y < image.height(); ++y) {
    std::string line;
    for (Index x = 0; x < image.width(); ++x) {
      const int value = image.at(x, y);
      line += value == 255 ? '#' : (value == 0 ? '.' : '?');
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace thinbench
