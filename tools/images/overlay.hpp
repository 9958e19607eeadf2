// Lines, discs and numbers drawn over a grey image, as pixels or as SVG.
#pragma once

#include <string>
#include <vector>

#include "images/canvas.hpp"

namespace thinbench {

/// Between centres of pixels.
struct OverlayLine {
  std::vector<Pixel> points;  // one point is drawn as a pixel
  OverlayColour colour;
  bool is_closed = false;
  double width = 1;  // in pixels
  double opacity = 1;
  std::string title = {};  // that SVG shows under the pointer
};

struct OverlayDisc {
  double x, y;
  double radius;
  OverlayColour colour;
  std::string title = {};
};

struct OverlayText {
  Pixel corner;      // lower left; moved so far that all of the text lies in the image
  std::string text;  // digits
  OverlayColour colour;
};

/// In the order in which it is drawn.
struct Overlay {
  std::vector<OverlayLine> lines;
  std::vector<OverlayDisc> discs;
  std::vector<OverlayText> texts;
  bool is_faded = false;  // the image, halfway to white
};

/// Width and height of the digits of a text, as pixels.
[[nodiscard]] Pixel overlay_text_size(const std::string& text);

/// Writes `grey` with the overlay, in colours: as SVG where the name ends in .svg, else as an
/// image. The file appears as a whole or not at all. Throws FileError.
void write_overlay(const std::string& path, const ConstImageView& grey, const Overlay& overlay);

}  // namespace thinbench
