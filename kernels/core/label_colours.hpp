// Label images as binary images.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/byte_image.hpp"

namespace thinbench::detail {

/// Splits labels into colours. Labels of one colour do not touch, not even at corners, so that
/// functions of binary images do for all labels of a colour at once.
class LabelColours {
 public:
  using Colour = std::uint32_t;  // 0: background

  explicit LabelColours(const ConstLabelView& labels);

  /// Calls `body(mask)` with the binary image of each colour; without labels, of one that is empty.
  template <class Body>
  void for_each(const Body& body) {
    for (Colour colour = 1; colour <= count_; ++colour) {
      for (Index y = 0; y < labels_.height; ++y) draw_mask_row(y, colour);
      body(mask_.view());
    }
  }

  [[nodiscard]] Colour count() const { return count_; }

 private:
  void paint(const std::unordered_map<std::int32_t, Colour>& colours);
  void draw_mask_row(Index y, Colour colour);

  ConstLabelView labels_;
  ByteImage mask_;
  std::vector<Colour> painted_;  // empty if one colour does
  Colour count_ = 1;
};

}  // namespace thinbench::detail
