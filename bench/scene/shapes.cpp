#include "scene/shapes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "scene/integer_math.hpp"

namespace thinbench::scene_detail {
namespace {

constexpr int kStepsPerTurn = 96;
constexpr int kStepsPerQuarter = kStepsPerTurn / 4;

/// 2^14 times the sine of 0, 1/96, ... 24/96 of a turn.
constexpr std::array<Unit, kStepsPerQuarter + 1> kSine = {
    0,     1072,  2139,  3196,  4240,  5266,  6270,  7246,  8192,  9102,  9974,  10803, 11585,
    12318, 12998, 13623, 14189, 14694, 15137, 15515, 15826, 16069, 16244, 16349, 16384};
constexpr Unit kSineOne = 16384;

Unit sine(int step) {
  const int turn = ((step % kStepsPerTurn) + kStepsPerTurn) % kStepsPerTurn;
  const int half = turn % (2 * kStepsPerQuarter);
  const int quarter = half <= kStepsPerQuarter ? half : 2 * kStepsPerQuarter - half;
  const Unit value = kSine[static_cast<std::size_t>(quarter)];
  return turn == half ? value : -value;
}

/// `length` along `direction`, exactly; throws where that is no whole number of units.
Point along(Point direction, Unit length) {
  const Unit square = direction.x * direction.x + direction.y * direction.y;
  const Unit norm = floor_sqrt(square);
  const Point step = direction * length;
  if (norm == 0 || norm * norm != square || step.x % norm != 0 || step.y % norm != 0) {
    throw std::invalid_argument("scene: outline point off the unit grid");
  }
  return {step.x / norm, step.y / norm};
}

/// A quarter circle from `from` to `to`, cut in two where it passes its highest or lowest point.
void append_quarter(Contour& contour, Point from, Point to, Point centre, Unit radius) {
  const Point a = from - centre;
  const Point b = to - centre;
  if (a.x * b.x >= 0) {
    contour.push_back({from, to, centre, radius});
    return;
  }
  const Point turn = centre + Point{0, a.y + b.y > 0 ? radius : -radius};
  contour.push_back({from, turn, centre, radius});
  contour.push_back({turn, to, centre, radius});
}

struct Ends {
  Point entry;
  Point exit;
};

/// Where a corner's arc begins and ends; both are the corner itself without one.
Ends corner_ends(Point before, const Corner& corner, Point after) {
  if (corner.radius == 0) return {corner.at, corner.at};
  return {corner.at - along(corner.at - before, corner.radius),
          corner.at + along(after - corner.at, corner.radius)};
}

Point left_of(Point direction) {
  return {direction.y, -direction.x};
}

Point heading(Point from, Point to) {
  const Unit length = floor_sqrt((to - from).x * (to - from).x + (to - from).y * (to - from).y);
  return {(to - from).x / length, (to - from).y / length};
}

/// The two corners that close a stroke at `end`, which it reaches in the given direction.
void append_cap(std::vector<Corner>& corners, Point end, Point direction, Unit half_width) {
  const Point tip = end + direction * half_width;
  corners.push_back({tip + left_of(direction) * half_width, half_width});
  corners.push_back({tip - left_of(direction) * half_width, half_width});
}

/// The left flank of a stroke, from its first point to the cap around its last one.
void append_flank(std::vector<Corner>& corners, const StrokeSpec& spec) {
  const std::vector<Point>& points = spec.points;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Point in = heading(points[i - 1], points[i]);
    const Point out = heading(points[i], points[i + 1]);
    const bool turns_left = left_of(in) == out;
    corners.push_back({points[i] + (left_of(in) + left_of(out)) * spec.half_width,
                       spec.bend_radius + (turns_left ? -spec.half_width : spec.half_width)});
  }
  const Point last = points.back();
  append_cap(corners, last, heading(points[points.size() - 2], last), spec.half_width);
}

}  // namespace

Contour polygon(std::span<const Corner> corners) {
  const std::size_t count = corners.size();
  std::vector<Ends> ends;
  for (std::size_t i = 0; i < count; ++i) {
    ends.push_back(
        corner_ends(corners[(i + count - 1) % count].at, corners[i], corners[(i + 1) % count].at));
  }
  Contour contour;
  for (std::size_t i = 0; i < count; ++i) {
    const auto [entry, exit] = ends[i];
    if (corners[i].radius > 0) {
      append_quarter(contour, entry, exit, entry + exit - corners[i].at, corners[i].radius);
    }
    const Point next = ends[(i + 1) % count].entry;
    if (!(next == exit)) contour.push_back({exit, next, {}, 0});
  }
  return contour;
}

Contour circle(Point centre, Unit radius) {
  return rectangle({centre, radius, radius, radius, {1, 0}});
}

Contour rectangle(const RectangleSpec& spec) {
  const Point length = along(spec.axis, spec.half_length);
  const Point width = along({-spec.axis.y, spec.axis.x}, spec.half_width);
  const std::array<Corner, 4> corners = {{{spec.centre - length - width, spec.radius},
                                          {spec.centre + length - width, spec.radius},
                                          {spec.centre + length + width, spec.radius},
                                          {spec.centre - length + width, spec.radius}}};
  return polygon(corners);
}

Contour stroke(const StrokeSpec& spec) {
  StrokeSpec back = spec;
  std::reverse(back.points.begin(), back.points.end());
  std::vector<Corner> corners;
  append_flank(corners, spec);
  append_flank(corners, back);
  return polygon(corners);
}

Contour hexagon(Point centre, Unit corner_radius) {
  std::array<Corner, 6> corners;
  int step = 0;
  for (Corner& corner : corners) {
    corner.at = on_circle(centre, corner_radius, step);
    step += kStepsPerTurn / 6;
  }
  return polygon(corners);
}

Contour gear(Point centre, int teeth, Unit root_radius, Unit tip_radius) {
  const int pitch = kStepsPerTurn / teeth;
  // Flanks take one step each, tip and root share the rest.
  const int land = (pitch - 2) / 2;
  std::vector<Corner> corners;
  for (int step = 0; step < kStepsPerTurn; step += pitch) {
    corners.push_back({on_circle(centre, root_radius, step), 0});
    corners.push_back({on_circle(centre, tip_radius, step + 1), 0});
    corners.push_back({on_circle(centre, tip_radius, step + 1 + land), 0});
    corners.push_back({on_circle(centre, root_radius, step + 2 + land), 0});
  }
  return polygon(corners);
}

Point on_circle(Point centre, Unit radius, int step) {
  return centre + Point{round_div(radius * sine(step + kStepsPerQuarter), kSineOne),
                        round_div(radius * sine(step), kSineOne)};
}

Contour reversed(const Contour& contour) {
  Contour result(contour.rbegin(), contour.rend());
  for (Edge& edge : result) std::swap(edge.from, edge.to);
  return result;
}

Contour placed(const Contour& contour, Unit factor, Point offset) {
  Contour result = contour;
  for (Edge& edge : result) {
    edge.from = edge.from * factor + offset;
    edge.to = edge.to * factor + offset;
    edge.centre = edge.centre * factor + offset;
    edge.radius *= factor;
  }
  return result;
}

}  // namespace thinbench::scene_detail
