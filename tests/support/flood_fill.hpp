// Connected components by flood fill: an oracle that shares no code with the library.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "support/byte_image.hpp"

namespace thinbench::flood_fill {

struct Component {
  Index first = 0;  // raster index of the first pixel
  double area = 0;
  double x = 0;  // the centre: mean of the pixels' coordinates
  double y = 0;
  bool touches_border = false;
};

struct Components {
  std::vector<int> label;  // per pixel, from 1; 0 if the pixel has another value
  std::vector<Component> list;
};

/// Labels the components of all pixels with one value.
class FloodFill {
 public:
  FloodFill(ConstImageView image, int value, bool eight_connected)
      : image_(image), value_(value), eight_connected_(eight_connected) {
    result_.label.assign(static_cast<std::size_t>(image.width * image.height), 0);
    for (Index y = 0; y < image.height; ++y) {
      for (Index x = 0; x < image.width; ++x) {
        if (is_unlabelled(x, y)) fill(x, y);
      }
    }
  }

  Components take() { return std::move(result_); }

 private:
  int& label(Index x, Index y) {
    return result_.label[static_cast<std::size_t>(y * image_.width + x)];
  }

  bool is_unlabelled(Index x, Index y) {
    return x >= 0 && y >= 0 && x < image_.width && y < image_.height &&
           image_.row(y)[x] == value_ && label(x, y) == 0;
  }

  void visit(Index x, Index y) {
    if (!is_unlabelled(x, y)) return;
    label(x, y) = static_cast<int>(result_.list.size());
    stack_.emplace_back(x, y);
  }

  void count(Component& component, Index x, Index y) const {
    component.area += 1;
    component.x += static_cast<double>(x);
    component.y += static_cast<double>(y);
    if (x == 0 || y == 0 || x == image_.width - 1 || y == image_.height - 1) {
      component.touches_border = true;
    }
  }

  void fill(Index x0, Index y0) {
    result_.list.push_back({y0 * image_.width + x0});
    visit(x0, y0);
    while (!stack_.empty()) {
      const auto [x, y] = stack_.back();
      stack_.pop_back();
      count(result_.list.back(), x, y);
      for (Index dy = -1; dy <= 1; ++dy) {
        for (Index dx = -1; dx <= 1; ++dx) {
          if (eight_connected_ || dx == 0 || dy == 0) visit(x + dx, y + dy);
        }
      }
    }
    Component& done = result_.list.back();
    done.x /= done.area;
    done.y /= done.area;
  }

  ConstImageView image_;
  int value_;
  bool eight_connected_;
  Components result_;
  std::vector<std::pair<Index, Index>> stack_;
};

/// 8-connected objects of a binary image, in raster order.
inline Components objects_of(ConstImageView binary) {
  return FloodFill(binary, 255, true).take();
}

/// 4-connected background components that do not touch the image border, in raster order.
inline std::vector<Component> holes_of(ConstImageView binary) {
  std::vector<Component> holes = FloodFill(binary, 0, false).take().list;
  std::erase_if(holes, [](const Component& component) { return component.touches_border; });
  return holes;
}

}  // namespace thinbench::flood_fill
