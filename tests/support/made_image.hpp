// Images of text, of one value, of other images' pixels or by thinning; images of labels.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "support/byte_image.hpp"
#include "support/made_image.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {

/// '#' is foreground, '.' is background; all lines have the same length.
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

struct LabelImage {
  Index width;
  Index height;
  std::vector<std::int32_t> labels;

  [[nodiscard]] ConstLabelView view() const { return {labels.data(), width, height}; }
  [[nodiscard]] LabelView view() { return {labels.data(), width, height}; }
};

/// A digit is a label, '.' is background; all lines have the same length.
inline LabelImage labels_of(const TextImage& lines) {
  LabelImage image = {
      static_cast<Index>(lines.front().size()), static_cast<Index>(lines.size()), {}};
  for (const std::string& line : lines) {
    for (const char c : line) image.labels.push_back(c == '.' ? 0 : c - '0');
  }
  return image;
}

/// Labels side by side, negative ones among them, or labels on lines with gaps.
inline LabelImage random_labels(std::mt19937& random) {
  LabelImage image = {
      1 + static_cast<Index>(random() % 70), 1 + static_cast<Index>(random() % 12), {}};
  const unsigned labels = 1 + static_cast<unsigned>(random() % 7);
  const unsigned rarity = 1 + static_cast<unsigned>(random() % 5);
  for (Index i = 0; i < image.width * image.height; ++i) {
    const bool is_drawn = random() % rarity == 0;
    const auto label = static_cast<std::int32_t>(random() % labels) - 2;
    image.labels.push_back(is_drawn ? label : 0);
  }
  return image;
}

}  // namespace thinbench
