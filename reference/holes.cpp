#include "holes.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "matrix.hpp"

namespace thinbench::reference {
namespace {

struct Point {
  Index x;
  Index y;
};

enum class Neighbours : std::uint8_t { four, eight };

/// An image with a background margin one pixel wide, and the number of each pixel's region.
class Flood {
 public:
  explicit Flood(const ConstImageView& source)
      : image_(matrix_of(source)),
        width_(source.width),
        height_(source.height),
        numbers_(static_cast<std::size_t>((width_ + 2) * (height_ + 2)), 0) {}

  [[nodiscard]] bool foreground(Index x, Index y) const { return image_.at(x, y); }
  [[nodiscard]] std::uint32_t& number(Index x, Index y) {
    return numbers_[static_cast<std::size_t>((y + 1) * (width_ + 2) + x + 1)];
  }

  /// Numbers all pixels connected to (x, y) and returns their region.
  Region fill(Index x, Index y, Neighbours neighbours, std::uint32_t with) {
    const auto column = static_cast<std::int32_t>(x);
    const auto row = static_cast<std::int32_t>(y);
    Region region{0, 0, 0, column, row, column, row, 0};
    std::vector<Point> stack = {{x, y}};
    number(x, y) = with;
    while (!stack.empty()) {
      const Point here = stack.back();
      stack.pop_back();
      add(region, here);
      for (Index dy = -1; dy <= 1; ++dy) {
        for (Index dx = -1; dx <= 1; ++dx) {
          if (neighbours == Neighbours::four && dx != 0 && dy != 0) continue;
          const Point next = {here.x + dx, here.y + dy};
          if (!inside_margin(next) || number(next.x, next.y) != 0) continue;
          if (foreground(next.x, next.y) != foreground(x, y)) continue;
          number(next.x, next.y) = with;
          stack.push_back(next);
        }
      }
    }
    return region;
  }

 private:
  [[nodiscard]] bool inside_margin(const Point& point) const {
    return point.x >= -1 && point.x <= width_ && point.y >= -1 && point.y <= height_;
  }

  static void add(Region& region, const Point& point) {
    const auto x = static_cast<std::int32_t>(point.x);
    const auto y = static_cast<std::int32_t>(point.y);
    region.area += 1;
    region.sum_x += x;
    region.sum_y += y;
    region.left = std::min(region.left, x);
    region.top = std::min(region.top, y);
    region.right = std::max(region.right, x);
    region.bottom = std::max(region.bottom, y);
  }

  Matrix image_;
  Index width_;
  Index height_;
  std::vector<std::uint32_t> numbers_;
};

constexpr std::uint32_t kOutside = UINT32_MAX;

/// The western neighbour of a hole's first pixel belongs to the enclosing object.
Regions find(Flood& flood, const ConstImageView& source, Neighbours of_objects) {
  const Neighbours of_holes =
      of_objects == Neighbours::eight ? Neighbours::four : Neighbours::eight;
  Regions found;
  static_cast<void>(flood.fill(-1, -1, of_holes, kOutside));
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      if (flood.number(x, y) != 0) continue;
      const bool is_object = flood.foreground(x, y);
      std::vector<Region>& list = is_object ? found.objects : found.holes;
      const auto id = static_cast<std::uint32_t>(list.size() + 1);
      list.push_back(flood.fill(x, y, is_object ? of_objects : of_holes, id));
      if (!is_object) list.back().enclosing_object = flood.number(x - 1, y);
    }
  }
  return found;
}

Regions find(const ConstImageView& source, Neighbours of_objects) {
  Flood flood(source);
  return find(flood, source, of_objects);
}

std::vector<Region> label_objects(const ConstImageView& source, const LabelView& labels,
                                  Neighbours neighbours) {
  Flood flood(source);
  Regions found = find(flood, source, neighbours);
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      labels.row(y)[x] = flood.foreground(x, y) ? static_cast<std::int32_t>(flood.number(x, y)) : 0;
    }
  }
  return found.objects;
}

/// Writes 255 but on background that is connected to the border.
void fill_outside(const ConstImageView& source, const ImageView& destination,
                  Neighbours of_background) {
  Flood flood(source);
  static_cast<void>(flood.fill(-1, -1, of_background, kOutside));
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      destination.row(y)[x] = flood.number(x, y) == kOutside ? 0 : 255;
    }
  }
}

/// The hole that a pixel of the background gets its label from.
struct LabelHole {
  Index begins = -1;  // where, in raster order; -1 for none
  std::int32_t label = 0;
};

/// Replaces holes by those of this label that begin later.
void take_holes_of(std::int32_t label, const ConstLabelView& source, Neighbours of_labels,
                   std::vector<LabelHole>& taken) {
  std::vector<std::uint8_t> alone;
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) alone.push_back(source.row(y)[x] == label ? 255 : 0);
  }
  const ConstImageView image = {alone.data(), source.width, source.height};
  Flood flood(image);
  static_cast<void>(find(flood, image, of_labels));
  std::map<std::uint32_t, Index> begins;
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      const std::uint32_t number = flood.number(x, y);
      if (flood.foreground(x, y) || number == kOutside) continue;
      const Index here = y * source.width + x;
      const Index begin = begins.try_emplace(number, here).first->second;
      LabelHole& hole = taken[static_cast<std::size_t>(here)];
      if (begin > hole.begins) hole = {begin, label};
    }
  }
}

std::int64_t objects_minus_holes(const Regions& found) {
  return static_cast<std::int64_t>(found.objects.size()) -
         static_cast<std::int64_t>(found.holes.size());
}

}  // namespace

Regions holes(ConstImageView source) {
  return find(source, Neighbours::eight);
}

Regions objects(ConstImageView source) {
  return {find(source, Neighbours::eight).objects, {}};
}

Regions label_regions(ConstImageView source, LabelView labels) {
  Flood flood(source);
  Regions found = find(flood, source, Neighbours::eight);
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      const std::uint32_t number = flood.number(x, y);
      const std::size_t before = flood.foreground(x, y) ? 0 : found.objects.size();
      labels.row(y)[x] = number == kOutside ? 0 : static_cast<std::int32_t>(before + number);
    }
  }
  return found;
}

std::vector<Region> label_objects(ConstImageView source, LabelView labels) {
  return label_objects(source, labels, Neighbours::eight);
}

std::vector<Region> label_objects_4(ConstImageView source, LabelView labels) {
  return label_objects(source, labels, Neighbours::four);
}

void fill_holes(ConstImageView source, ImageView destination) {
  fill_outside(source, destination, Neighbours::four);
}

void fill_holes_4(ConstImageView source, ImageView destination) {
  fill_outside(source, destination, Neighbours::eight);
}

void fill_small_holes(ConstImageView source, ImageView destination, bool four_connected,
                      std::int64_t max_area) {
  Flood flood(source);
  const Regions found = find(flood, source, four_connected ? Neighbours::four : Neighbours::eight);
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      const std::uint32_t number = flood.number(x, y);
      const bool fills = number != kOutside &&
                         (flood.foreground(x, y) || found.holes[number - 1].area <= max_area);
      destination.row(y)[x] = fills ? 255 : 0;
    }
  }
}

void fill_label_holes(ConstLabelView source, LabelView destination, bool four_connected,
                      std::int64_t max_area) {
  std::set<std::int32_t> labels;
  for (Index y = 0; y < source.height; ++y)
    labels.insert(source.row(y), source.row(y) + source.width);
  labels.erase(0);
  std::vector<LabelHole> taken(static_cast<std::size_t>(source.width * source.height));
  for (const std::int32_t label : labels) {
    take_holes_of(label, source, four_connected ? Neighbours::four : Neighbours::eight, taken);
  }
  const auto hole_at = [&](Index x, Index y) {
    return source.row(y)[x] == 0 ? taken[static_cast<std::size_t>(y * source.width + x)]
                                 : LabelHole{};
  };
  std::map<Index, std::int64_t> areas;
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) ++areas[hole_at(x, y).begins];
  }
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      const LabelHole hole = hole_at(x, y);
      const bool fills = hole.begins >= 0 && areas[hole.begins] <= max_area;
      destination.row(y)[x] = fills ? hole.label : source.row(y)[x];
    }
  }
}

std::int64_t euler_number(ConstImageView source) {
  return objects_minus_holes(find(source, Neighbours::eight));
}

std::int64_t euler_number_4(ConstImageView source) {
  return objects_minus_holes(find(source, Neighbours::four));
}

}  // namespace thinbench::reference
