// Area coverage of pixels by outlines, through 16 x 16 samples per pixel.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/shapes.hpp"
#include "support/byte_image.hpp"

namespace thinbench::scene_detail {

/// A rectangle of pixels.
struct PixelBox {
  Index x = 0;
  Index y = 0;
  Index width = 0;
  Index height = 0;
};

/// Samples inside the outlines, for each pixel of a box: 0 is outside, kFullCoverage inside.
class CoverageMap {
 public:
  static constexpr int kFullCoverage = 256;

  /// Adds the winding of all contours, so an anticlockwise hole takes away what its part gave.
  CoverageMap(PixelBox box, std::span<const Contour> contours);

  [[nodiscard]] const PixelBox& box() const { return box_; }
  /// Coverage of the box's row `y` (counted from its top), `box().width` values.
  [[nodiscard]] const std::int16_t* row(Index y) const { return cells_.data() + y * pitch_; }

 private:
  void mark_edge(const Edge& edge);
  void mark_crossing(std::int64_t sample_row, std::int64_t sample_column, int winding);
  void accumulate_rows();

  PixelBox box_;
  Index pitch_;
  std::vector<std::int16_t> cells_;
};

/// The pixels of a `width` x `height` image that an outline may cover.
[[nodiscard]] PixelBox covered_box(const Contour& contour, Index width, Index height);

}  // namespace thinbench::scene_detail
