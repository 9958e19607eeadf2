#include "localise.hpp"

#include "matrix.hpp"

namespace thinbench::reference {
namespace {

/// The class of a pixel; the margin, one pixel wide, is background.
enum class Kind : std::uint8_t { unknown, outside, outermost_contour, inside };

class Outlines {
 public:
  explicit Outlines(const ConstImageView& contours)
      : contours_(matrix_of(contours)),
        width_(contours.width),
        height_(contours.height),
        kinds_(static_cast<std::size_t>((width_ + 2) * (height_ + 2)), Kind::unknown) {
    spread(-1, -1, Kind::outside);
    spread_all_beside(Kind::outside, Kind::outermost_contour);
    spread_all_beside(Kind::outermost_contour, Kind::inside);
  }

  [[nodiscard]] Kind& kind(Index x, Index y) {
    return kinds_[static_cast<std::size_t>((y + 1) * (width_ + 2) + x + 1)];
  }

 private:
  struct Point {
    Index x;
    Index y;
  };

  [[nodiscard]] bool takes(Kind kind, Index x, Index y) {
    const bool inside_margin = x >= -1 && x <= width_ && y >= -1 && y <= height_;
    if (!inside_margin || this->kind(x, y) != Kind::unknown) return false;
    return contours_.at(x, y) == (kind == Kind::outermost_contour);
  }

  /// Assigns a kind to (x, y) and all pixels connected to it: contours are 8-connected, regions
  /// between them 4-connected.
  void spread(Index x, Index y, Kind kind) {
    std::vector<Point> stack = {{x, y}};
    this->kind(x, y) = kind;
    while (!stack.empty()) {
      const Point here = stack.back();
      stack.pop_back();
      for (Index dy = -1; dy <= 1; ++dy) {
        for (Index dx = -1; dx <= 1; ++dx) {
          const Point next = {here.x + dx, here.y + dy};
          const bool is_neighbour = kind == Kind::outermost_contour || dx == 0 || dy == 0;
          if (!is_neighbour || !takes(kind, next.x, next.y)) continue;
          this->kind(next.x, next.y) = kind;
          stack.push_back(next);
        }
      }
    }
  }

  void spread_all_beside(Kind neighbour, Kind kind) {
    const auto is_beside = [&](Index x, Index y) {
      return this->kind(x - 1, y) == neighbour || this->kind(x, y - 1) == neighbour ||
             this->kind(x + 1, y) == neighbour || this->kind(x, y + 1) == neighbour;
    };
    for (Index y = 0; y < height_; ++y) {
      for (Index x = 0; x < width_; ++x) {
        if (takes(kind, x, y) && is_beside(x, y)) spread(x, y, kind);
      }
    }
  }

  Matrix contours_;
  Index width_;
  Index height_;
  std::vector<Kind> kinds_;
};

}  // namespace

void outlined_objects(ConstImageView contours, ImageView destination) {
  Outlines outlines(contours);
  for (Index y = 0; y < contours.height; ++y) {
    for (Index x = 0; x < contours.width; ++x) {
      const Kind kind = outlines.kind(x, y);
      const bool is_object = kind == Kind::outermost_contour || kind == Kind::inside;
      destination.row(y)[x] = is_object ? 255 : 0;
    }
  }
}

Regions localise_objects(EdgeDetection edges, const EdgeThresholds& thresholds,
                         ConstImageView source) {
  const auto pixels = static_cast<std::size_t>(source.width * source.height);
  std::vector<std::uint8_t> contours(pixels);
  std::vector<std::uint8_t> objects(pixels);
  const auto view = [&](std::vector<std::uint8_t>& image) {
    return ImageView{image.data(), source.width, source.height, source.width};
  };
  edges(thresholds, source, view(contours));
  outlined_objects(view(contours), view(objects));
  return holes(view(objects));
}

}  // namespace thinbench::reference
