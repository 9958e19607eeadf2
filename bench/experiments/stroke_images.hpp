// Many small images of strokes, as scanned digits are.
#pragma once

#include <cstdint>
#include <vector>

#include "thinbench/image_view.hpp"

namespace thinbench {

/// Owns images of one size without gaps, background at first.
class ImageStack {
 public:
  ImageStack(Index count, Index side);

  [[nodiscard]] ConstStackView view() const;
  [[nodiscard]] StackView view();

 private:
  Index count_;
  Index side_;
  std::vector<std::uint8_t> pixels_;
};

/// Images of `side` x `side` pixels, each a line through 3 to 6 random points, 2 to 4 28ths of the
/// side thick, whose points are 4 28ths of it or more from the image border. Sides up to 1024. The
/// same bytes on every machine.
[[nodiscard]] ImageStack stroke_images(Index count, Index side, std::uint64_t seed);

/// Foreground pixels of all, from 0 to 1; 0 without pixels.
[[nodiscard]] double foreground_share(const ConstStackView& stack);

}  // namespace thinbench
