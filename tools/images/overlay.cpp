#include "images/overlay.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "images/image_file.hpp"
#include "support/text.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

/// The corner, so that all of the text lies in the image.
Pixel corner_inside(const OverlayText& text, Index width, Index height) {
  const Pixel size = overlay_text_size(text.text);
  const auto columns = static_cast<int>(width), rows = static_cast<int>(height);
  return {std::clamp(text.corner.x, 0, std::max(0, columns - size.x)),
          std::clamp(text.corner.y, size.y, std::max(size.y, rows - 1))};
}

Canvas drawn(const ConstImageView& grey, const Overlay& overlay) {
  Canvas canvas(grey, overlay.is_faded);
  for (const OverlayLine& line : overlay.lines) {
    if (line.width > 1 || line.opacity < 1) {
      canvas.draw_band(line.points, line.width, line.opacity, line.colour);
    } else {
      canvas.draw_line(line.points, line.is_closed, line.colour);
    }
  }
  for (const OverlayDisc& disc : overlay.discs) {
    canvas.draw_disc(disc.x, disc.y, disc.radius, disc.colour);
  }
  for (const OverlayText& text : overlay.texts) {
    canvas.draw_digits(corner_inside(text, grey.width, grey.height), text.text, text.colour);
  }
  return canvas;
}

using Buffer = std::back_insert_iterator<std::string>;

std::string name_of(const OverlayColour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

std::string title_of(const std::string& title) {
  return title.empty() ? "" : fmt::format("<title>{}</title>", title);
}

/// Whether the middle pixel lies on the way between the others, as in outlines of many pixels.
bool is_between(Pixel a, Pixel b, Pixel c) {
  return b.x - a.x == c.x - b.x && b.y - a.y == c.y - b.y;
}

void add_svg(const OverlayLine& line, Buffer to) {
  fmt::format_to(to, "<{} points=\"", line.is_closed ? "polygon" : "polyline");
  const std::vector<Pixel>& points = line.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_inside = i > 0 && i + 1 < points.size();
    if (is_inside && is_between(points[i - 1], points[i], points[i + 1])) continue;
    fmt::format_to(to, "{},{} ", points[i].x, points[i].y);
  }
  if (points.size() == 1) fmt::format_to(to, "{},{}", points[0].x, points[0].y);
  fmt::format_to(to, "\" stroke=\"{}\" stroke-width=\"{}\" stroke-opacity=\"{}\">{}</{}>\n",
                 name_of(line.colour), std::max(1.0, line.width), line.opacity,
                 title_of(line.title), line.is_closed ? "polygon" : "polyline");
}

void add_svg(const OverlayDisc& disc, Buffer to) {
  fmt::format_to(to, "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"{}\">{}</circle>\n",
                 disc.x, disc.y, disc.radius, name_of(disc.colour), title_of(disc.title));
}

void add_svg(const OverlayText& text, Pixel corner, Buffer to) {
  fmt::format_to(to, "<text x=\"{}\" y=\"{}\" fill=\"{}\">{}</text>\n", corner.x, corner.y,
                 name_of(text.colour), text.text);
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

std::string svg_of(const ConstImageView& grey, const Overlay& overlay) {
  constexpr Index small_side = 800;
  const Index scale = std::max<Index>(1, small_side / std::max(grey.width, grey.height));
  std::string text = fmt::format(
      R"svg(<svg xmlns="http://www.w3.org/2000/svg" width="{}" height="{}" viewBox="0 0 {} {}">
<image width="{}" height="{}" style="image-rendering: pixelated; opacity: {}" href="data:image/png;base64,{}"/>
<g transform="translate(0.5 0.5)" font-family="sans-serif" font-size="10">
<g fill="none" stroke-linejoin="round" stroke-linecap="round">
)svg",
      scale * grey.width, scale * grey.height, grey.width, grey.height, grey.width, grey.height,
      overlay.is_faded ? 0.5 : 1.0, base64(png_of(grey)));
  const Buffer to(text);
  for (const OverlayLine& line : overlay.lines) add_svg(line, to);
  text += "</g>\n";
  for (const OverlayDisc& disc : overlay.discs) add_svg(disc, to);
  for (const OverlayText& number : overlay.texts) {
    add_svg(number, corner_inside(number, grey.width, grey.height), to);
  }
  return text + "</g>\n</svg>\n";
}

bool is_svg(const std::string& path) {
  return extension_of(path) == ".svg";
}

}  // namespace

Pixel overlay_text_size(const std::string& text) {
  return {kDigitStep * static_cast<int>(text.size()), kDigitHeight};
}

void write_overlay(const std::string& path, const ConstImageView& grey, const Overlay& overlay) {
  check_overlay_extension(path);
  if (is_svg(path)) return write_whole_file(path, svg_of(grey, overlay));
  const Canvas canvas = drawn(grey, overlay);
  write_colours(path, canvas.colours(), canvas.width(), canvas.height());
}

}  // namespace thinbench
