// Images as OpenCV has them. Includes OpenCV.
#pragma once

#include <opencv2/core.hpp>

#include "thinbench/image_view.hpp"

namespace thinbench {

/// OpenCV knows no read-only images: what is made of a constant view must not be written to.
[[nodiscard]] inline cv::Mat mat_of(const ConstImageView& view) {
  return {static_cast<int>(view.height), static_cast<int>(view.width), CV_8UC1,
          const_cast<std::uint8_t*>(view.data), static_cast<std::size_t>(view.stride)};
}

}  // namespace thinbench
