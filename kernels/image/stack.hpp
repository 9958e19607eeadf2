// Plain views of stacks: many images of one size, one after another in memory. As views.hpp: no
// owner, no library, safe in every ISA file.
#pragma once

#include "image/plane_view.hpp"

namespace thinbench::detail {

/// Pixel (x, y) of image i is `data[i * image_stride + y * stride + x]`. Both strides count bytes;
/// images may have gaps between them and between their rows, and share no byte.
struct ConstStackView {
  const std::uint8_t* data = nullptr;
  Index count = 0;
  Index width = 0;
  Index height = 0;
  Index stride = 0;
  Index image_stride = 0;

  [[nodiscard]] ConstImageView image(Index i) const {
    return {data + i * image_stride, width, height, stride};
  }
};

/// Writable, otherwise as ConstStackView.
struct StackView {
  std::uint8_t* data = nullptr;
  Index count = 0;
  Index width = 0;
  Index height = 0;
  Index stride = 0;
  Index image_stride = 0;

  [[nodiscard]] ImageView image(Index i) const {
    return {data + i * image_stride, width, height, stride};
  }
  operator ConstStackView() const { return {data, count, width, height, stride, image_stride}; }
};

}  // namespace thinbench::detail
