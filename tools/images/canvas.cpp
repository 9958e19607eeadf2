#include "images/canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace thinbench {

Canvas::Canvas(const ConstImageView& grey, bool is_faded)
    : width_(grey.width), height_(grey.height) {
  colours_.reserve(static_cast<std::size_t>(3 * width_ * height_));
  for (Index y = 0; y < height_; ++y) {
    for (Index x = 0; x < width_; ++x) {
      const std::uint8_t level = grey.row(y)[x];
      colours_.insert(colours_.end(), 3,
                      is_faded ? static_cast<std::uint8_t>(level / 2 + 128) : level);
    }
  }
}

void Canvas::set(Index x, Index y, const OverlayColour& colour) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  std::uint8_t* const pixel = colours_.data() + 3 * (y * width_ + x);
  pixel[0] = colour.red;
  pixel[1] = colour.green;
  pixel[2] = colour.blue;
}

void Canvas::draw_line(const std::vector<Pixel>& points, bool is_closed,
                       const OverlayColour& colour) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    draw_segment(points[i], points[i + 1], colour);
  if (is_closed || points.size() == 1) draw_segment(points.back(), points.front(), colour);
}

void Canvas::draw_segment(Pixel from, Pixel to, const OverlayColour& colour) {
  const Index dx = to.x - from.x, dy = to.y - from.y;
  const Index steps = std::max(std::abs(dx), std::abs(dy));
  for (Index i = 0; i <= steps; ++i) {
    const auto part = [&](Index d) {
      return steps == 0 ? 0 : (2 * d * i + (d < 0 ? -steps : steps)) / (2 * steps);
    };
    set(from.x + part(dx), from.y + part(dy), colour);
  }
}

namespace {

/// Pixels at most `radius` from a segment.
template <class Mark>
void mark_segment(Pixel a, Pixel b, double radius, Index height, const Mark& mark) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  const auto first = static_cast<Index>(std::max(0.0, std::ceil(std::min(a.y, b.y) - radius)));
  const auto last = static_cast<Index>(
      std::min(static_cast<double>(height - 1), std::floor(std::max(a.y, b.y) + radius)));
  for (Index y = first; y <= last; ++y) {
    double left = HUGE_VAL, right = -HUGE_VAL;
    const auto add = [&](double x, double reach) {
      left = std::min(left, x - reach);
      right = std::max(right, x + reach);
    };
    for (const Pixel end : {a, b}) {
      const double below = static_cast<double>(y) - end.y, rest = radius * radius - below * below;
      if (rest >= 0) add(end.x, std::sqrt(rest));
    }
    for (const double side : {-radius, radius}) {  // the two long sides of the band
      if (length == 0 || dy == 0) break;
      const double t = (static_cast<double>(y) - a.y - side * dx / length) / dy;
      if (t >= 0 && t <= 1) add(a.x + t * dx - side * dy / length, 0);
    }
    if (left <= right) mark(y, left, right);
  }
}

}  // namespace

void Canvas::draw_band(const std::vector<Pixel>& points, double width, double opacity,
                       const OverlayColour& colour) {
  std::vector<bool> marked(static_cast<std::size_t>(width_ * height_));
  const auto mark = [&](Index y, double left, double right) {
    const auto first = static_cast<Index>(std::max(0.0, std::ceil(left)));
    const auto end =
        static_cast<Index>(std::min(static_cast<double>(width_), std::floor(right) + 1));
    if (first >= end) return;
    const auto row = marked.begin() + y * width_;
    std::fill(row + first, row + end, true);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    mark_segment(points[i], points[std::min(i + 1, points.size() - 1)], width / 2, height_, mark);
  }
  const std::array<double, 3> channels = {static_cast<double>(colour.red),
                                          static_cast<double>(colour.green),
                                          static_cast<double>(colour.blue)};
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (!marked[i]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint8_t& level = colours_[3 * i + k];
      level = static_cast<std::uint8_t>(std::lround(opacity * channels[k] + (1 - opacity) * level));
    }
  }
}

void Canvas::draw_disc(double x, double y, double radius, const OverlayColour& colour) {
  const auto reach = static_cast<Index>(std::ceil(radius)) + 1;
  const auto column = static_cast<Index>(std::lround(x)), row = static_cast<Index>(std::lround(y));
  for (Index v = row - reach; v <= row + reach; ++v) {
    for (Index u = column - reach; u <= column + reach; ++u) {
      const auto dx = static_cast<double>(u - column), dy = static_cast<double>(v - row);
      if (dx * dx + dy * dy <= radius * radius + 0.25) set(u, v, colour);
    }
  }
}

void Canvas::draw_digits(Pixel corner, const std::string& text, const OverlayColour& colour) {
  // A number for each row of a digit, from the top; the highest of five bits is the left pixel.
  constexpr std::array<std::array<int, kDigitHeight>, 10> digits = {{{14, 17, 17, 17, 17, 17, 14},
                                                                     {4, 12, 4, 4, 4, 4, 14},
                                                                     {14, 17, 1, 2, 4, 8, 31},
                                                                     {31, 2, 4, 2, 1, 17, 14},
                                                                     {2, 6, 10, 18, 31, 2, 2},
                                                                     {31, 16, 30, 1, 1, 17, 14},
                                                                     {6, 8, 16, 30, 17, 17, 14},
                                                                     {31, 1, 2, 4, 8, 8, 8},
                                                                     {14, 17, 17, 14, 17, 17, 14},
                                                                     {14, 17, 17, 15, 1, 2, 12}}};
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto& digit = digits[static_cast<std::size_t>(std::clamp(text[i] - '0', 0, 9))];
    const Index left = corner.x + kDigitStep * static_cast<Index>(i);
    for (int y = 0; y < kDigitHeight; ++y) {
      for (int x = 0; x < kDigitWidth; ++x) {
        const bool is_set = (digit[static_cast<std::size_t>(y)] >> (kDigitWidth - 1 - x) & 1) != 0;
        if (is_set) set(left + x, corner.y - kDigitHeight + 1 + y, colour);
      }
    }
  }
}

}  // namespace thinbench
