#include "images/regions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace thinbench {

KeptRegions kept_regions(const Regions& found, std::int64_t min_area) {
  const auto is_large = [&](const Region& region) { return region.area >= min_area; };
  KeptRegions kept;
  for (std::size_t i = 0; i < found.objects.size(); ++i) {
    if (is_large(found.objects[i])) kept.objects.push_back(i);
  }
  for (std::size_t i = 0; i < found.holes.size(); ++i) {
    const Region& hole = found.holes[i];
    if (is_large(hole) && is_large(found.objects[hole.enclosing_object - 1]))
      kept.holes.push_back(i);
  }
  return kept;
}

Regions selected(const Regions& found, const KeptRegions& kept) {
  Regions result;
  std::vector<std::uint32_t> new_ids(found.objects.size() + 1);
  for (const std::size_t i : kept.objects) {
    result.objects.push_back(found.objects[i]);
    new_ids[i + 1] = static_cast<std::uint32_t>(result.objects.size());
  }
  for (const std::size_t i : kept.holes) {
    result.holes.push_back(found.holes[i]);
    result.holes.back().enclosing_object = new_ids[found.holes[i].enclosing_object];
  }
  return result;
}

namespace {

constexpr OverlayColour kObjectColour = {0, 170, 0};
constexpr OverlayColour kHoleColour = {255, 40, 40};

/// Follows borders between objects and background, as S. Suzuki and K. Abe do in "Topological
/// structural analysis of digitized binary images by border following", 1985, algorithm 1.
class BorderFollower {
 public:
  explicit BorderFollower(const ConstImageView& objects)
      : width_(objects.width),
        height_(objects.height),
        stride_(objects.width + 2),
        marks_(static_cast<std::size_t>(stride_ * (objects.height + 2)), kBackground),
        steps_{1, 1 - stride_, -stride_, -1 - stride_, -1, stride_ - 1, stride_, stride_ + 1} {
    for (Index y = 0; y < height_; ++y) {
      std::transform(objects.row(y), objects.row(y) + width_, &marks_[at(0, y)],
                     [](std::uint8_t pixel) { return pixel == 0 ? kBackground : kUnseen; });
    }
  }

  /// Calls outer(line) for each object and inner(line) for each hole, both in the order of their
  /// first pixels. An object's line begins with its first pixel, a hole's with the one left of it.
  template <class Outer, class Inner>
  void follow_all(const Outer& outer, const Inner& inner) {
    for (Index y = 0; y < height_; ++y) {
      for (Index x = 0; x < width_; ++x) {
        const std::size_t here = at(x, y);
        if (marks_[here] == kBackground) continue;
        if (marks_[here] == kUnseen && marks_[here - 1] == kBackground)
          outer(followed(x, y, kWest));
        const bool begins_hole = marks_[here] != kSeenOnTheRight && marks_[here + 1] == kBackground;
        if (begins_hole) inner(followed(x, y, kEast));
      }
    }
  }

 private:
  enum Mark : std::uint8_t { kBackground, kUnseen, kSeen, kSeenOnTheRight };
  static constexpr int kEast = 0, kWest = 4;  // directions count against the clock

  [[nodiscard]] std::size_t at(Index x, Index y) const {
    return static_cast<std::size_t>((y + 1) * stride_ + x + 1);
  }
  [[nodiscard]] std::size_t next(std::size_t place, int direction) const {
    return place + static_cast<std::size_t>(steps_[static_cast<std::size_t>(direction & 7)]);
  }

  /// From the pixel on, which has background in this direction.
  std::vector<Pixel> followed(Index x, Index y, int background) {
    const std::size_t start = at(x, y);
    int last = background - 1;  // the first object with the clock
    while (last > background - 8 && marks_[next(start, last)] == kBackground) --last;
    if (last == background - 8) {
      marks_[start] = kSeenOnTheRight;
      return {{static_cast<int>(x), static_cast<int>(y)}};
    }
    std::vector<Pixel> line;
    const std::size_t before = next(start, last);
    for (std::size_t here = start;;) {
      line.push_back(pixel_at(here));
      bool saw_right = false;
      int direction = last + 1;
      for (; marks_[next(here, direction)] == kBackground; ++direction) {
        saw_right = saw_right || (direction & 7) == kEast;
      }
      if (saw_right) marks_[here] = kSeenOnTheRight;
      if (marks_[here] == kUnseen) marks_[here] = kSeen;
      const std::size_t following = next(here, direction);
      if (following == start && here == before) return line;
      here = following;
      last = direction + 4;
    }
  }

  [[nodiscard]] Pixel pixel_at(std::size_t place) const {
    const auto i = static_cast<Index>(place);
    return {static_cast<int>(i % stride_ - 1), static_cast<int>(i / stride_ - 1)};
  }

  Index width_;
  Index height_;
  Index stride_;  // of marks, with a border of background
  std::vector<std::uint8_t> marks_;
  std::array<Index, 8> steps_;
};

using Line = std::vector<Pixel>;

/// The outlines of the regions that are kept.
struct Outlines {
  std::vector<Line> objects;
  std::vector<Line> holes;
};

Outlines outlines_of(const ConstImageView& objects, const KeptRegions& kept) {
  Outlines outlines;
  std::size_t object = 0, hole = 0;
  const auto keep = [](const std::vector<std::size_t>& positions, std::size_t& number, Line line,
                       std::vector<Line>& to) {
    if (to.size() < positions.size() && positions[to.size()] == number)
      to.push_back(std::move(line));
    ++number;
  };
  BorderFollower(objects).follow_all(
      [&](Line line) { keep(kept.objects, object, std::move(line), outlines.objects); },
      [&](Line line) { keep(kept.holes, hole, std::move(line), outlines.holes); });
  return outlines;
}

Pixel size_of(const Region& region) {
  return {region.right - region.left + 1, region.bottom - region.top + 1};
}

Pixel centre_of(const Region& region) {
  return {static_cast<int>(std::lrint(region.centre_x())),
          static_cast<int>(std::lrint(region.centre_y()))};
}

/// Whether a region is so large that numbers of its like leave the image readable.
bool is_numbered(const Region& region) {
  const Pixel digit = overlay_text_size("0");
  const Pixel size = size_of(region);
  return size.x > digit.x && size.y > digit.y;
}

/// A cross, or a point where a cross would hide the region.
void add_centre(Overlay& overlay, const Region& region, const OverlayColour& colour) {
  constexpr int arm = 2;
  const Pixel size = size_of(region), at = centre_of(region);
  if (std::min(size.x, size.y) <= 4 * arm + 2) {
    overlay.lines.push_back({{at}, colour});
    return;
  }
  overlay.lines.push_back({{{at.x - arm, at.y}, {at.x + arm, at.y}}, colour});
  overlay.lines.push_back({{{at.x, at.y - arm}, {at.x, at.y + arm}}, colour});
}

void add_number(Overlay& overlay, const Region& region, std::size_t id, Pixel corner,
                const OverlayColour& colour) {
  if (is_numbered(region)) overlay.texts.push_back({corner, std::to_string(id), colour});
}

}  // namespace

Overlay regions_overlay(const ConstImageView& objects, const Regions& found,
                        std::int64_t min_area) {
  const KeptRegions kept = kept_regions(found, min_area);
  const Outlines outlines = outlines_of(objects, kept);
  Overlay overlay;
  for (const Line& line : outlines.objects) overlay.lines.push_back({line, kObjectColour, true});
  for (const Line& line : outlines.holes) overlay.lines.push_back({line, kHoleColour, true});
  for (std::size_t i = 0; i < kept.objects.size(); ++i) {  // numbers stand above first pixels
    const Region& object = found.objects[kept.objects[i]];
    const Pixel first = outlines.objects[i].front();
    add_centre(overlay, object, kObjectColour);
    add_number(overlay, object, i + 1, {first.x, first.y - 2}, kObjectColour);
  }
  for (std::size_t i = 0; i < kept.holes.size(); ++i) {  // and beside centres of holes
    const Region& hole = found.holes[kept.holes[i]];
    const Pixel centre = centre_of(hole);
    add_centre(overlay, hole, kHoleColour);
    add_number(overlay, hole, i + 1, {centre.x + 3, centre.y - 3}, kHoleColour);
  }
  return overlay;
}

}  // namespace thinbench
