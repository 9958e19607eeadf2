// Label images as text: a digit is a label, '.' is background; all lines have the same length.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "support/text_image.hpp"

namespace thinbench {

struct LabelImage {
  Index width;
  Index height;
  std::vector<std::int32_t> labels;

  [[nodiscard]] ConstLabelView view() const { return {labels.data(), width, height}; }
  [[nodiscard]] LabelView view() { return {labels.data(), width, height}; }
};

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
