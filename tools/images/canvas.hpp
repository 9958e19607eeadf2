// A colour image that is drawn on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "thinbench/graph.hpp"
#include "thinbench/image_view.hpp"

namespace thinbench {

struct OverlayColour {
  std::uint8_t red, green, blue;
};

/// What lies outside is not drawn.
class Canvas {
 public:
  /// In grey, halfway to white where `is_faded`.
  Canvas(const ConstImageView& grey, bool is_faded);

  [[nodiscard]] Index width() const { return width_; }
  [[nodiscard]] Index height() const { return height_; }
  /// Red, green and blue of each pixel.
  [[nodiscard]] const std::vector<std::uint8_t>& colours() const { return colours_; }

  /// From pixel to pixel, one pixel wide.
  void draw_line(const std::vector<Pixel>& points, bool is_closed, const OverlayColour& colour);
  /// All pixels at most half of the width from the line, mixed with what is there, but once.
  void draw_band(const std::vector<Pixel>& points, double width, double opacity,
                 const OverlayColour& colour);
  void draw_disc(double x, double y, double radius, const OverlayColour& colour);
  /// Digits, from their lower left corner on.
  void draw_digits(Pixel corner, const std::string& text, const OverlayColour& colour);

 private:
  void set(Index x, Index y, const OverlayColour& colour);
  void draw_segment(Pixel from, Pixel to, const OverlayColour& colour);

  Index width_;
  Index height_;
  std::vector<std::uint8_t> colours_;
};

/// Of digits, in pixels.
inline constexpr int kDigitWidth = 5, kDigitHeight = 7, kDigitStep = 6;

}  // namespace thinbench
