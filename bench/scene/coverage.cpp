#include "scene/coverage.hpp"

#include <algorithm>
#include <cstddef>

#include "scene/integer_math.hpp"
#include "scene/truth.hpp"

namespace thinbench::scene_detail {
namespace {

constexpr std::int64_t kSamplesPerPixel = 16;
constexpr Unit kUnitsPerSample = kUnitsPerPixel / kSamplesPerPixel;
static_assert(kUnitsPerSample == 2, "samples sit at odd coordinates");

/// The crossing of an edge with the horizontal through `y`, rounded down to whole units.
Unit crossing_x(const Edge& edge, Unit y) {
  if (edge.radius == 0) {
    const auto [low, high] =
        std::minmax(edge.from, edge.to, [](Point a, Point b) { return a.y < b.y; });
    return low.x + floor_div((high.x - low.x) * (y - low.y), high.y - low.y);
  }
  const Unit rise = y - edge.centre.y;
  const Unit square = edge.radius * edge.radius - rise * rise;
  const bool right_side = edge.from.x + edge.to.x > 2 * edge.centre.x;
  return edge.centre.x + (right_side ? floor_sqrt(square) : -ceil_sqrt(square));
}

/// Sample k sits at coordinate 2 k + 1: number of samples at coordinates below `at`.
std::int64_t samples_below(Unit at) {
  return floor_div(at, kUnitsPerSample);
}

}  // namespace

CoverageMap::CoverageMap(PixelBox box, std::span<const Contour> contours)
    // Two spare cells take the marks of crossings at the right border and beyond it.
    : box_(box), pitch_(box.width + 2), cells_(static_cast<std::size_t>(pitch_ * box.height)) {
  for (const Contour& contour : contours) {
    for (const Edge& edge : contour) mark_edge(edge);
  }
  accumulate_rows();
}

void CoverageMap::mark_edge(const Edge& edge) {
  // On a clockwise outline the left flank runs upwards: the inside begins there.
  const int winding = edge.to.y < edge.from.y ? 1 : -1;
  const auto [top, bottom] = std::minmax(edge.from.y, edge.to.y);
  const std::int64_t first = std::max(samples_below(top), box_.y * kSamplesPerPixel);
  const std::int64_t last =
      std::min(samples_below(bottom), (box_.y + box_.height) * kSamplesPerPixel);
  for (std::int64_t row = first; row < last; ++row) {
    const Unit x = crossing_x(edge, kUnitsPerSample * row + 1);
    mark_crossing(row, samples_below(x + 1), winding);
  }
}

void CoverageMap::mark_crossing(std::int64_t sample_row, std::int64_t sample_column, int winding) {
  const std::int64_t column = std::clamp<std::int64_t>(sample_column - box_.x * kSamplesPerPixel, 0,
                                                       box_.width * kSamplesPerPixel);
  const std::int64_t skipped = column % kSamplesPerPixel;
  const Index y = sample_row / kSamplesPerPixel - box_.y;
  std::int16_t* cell = cells_.data() + y * pitch_ + column / kSamplesPerPixel;
  // Differences along the row: all samples from `column` on gain `winding`.
  cell[0] = static_cast<std::int16_t>(cell[0] + winding * (kSamplesPerPixel - skipped));
  cell[1] = static_cast<std::int16_t>(cell[1] + winding * skipped);
}

void CoverageMap::accumulate_rows() {
  for (Index y = 0; y < box_.height; ++y) {
    std::int16_t* cells = cells_.data() + y * pitch_;
    int sum = 0;
    for (Index x = 0; x < box_.width; ++x) {
      sum += cells[x];
      cells[x] = static_cast<std::int16_t>(sum);
    }
  }
}

PixelBox covered_box(const Contour& contour, Index width, Index height) {
  const Extent around = extent(contour);
  const Index left = std::clamp<Index>(floor_div(around.low.x, kUnitsPerPixel), 0, width);
  const Index top = std::clamp<Index>(floor_div(around.low.y, kUnitsPerPixel), 0, height);
  const Index right = std::clamp<Index>(floor_div(around.high.x, kUnitsPerPixel) + 1, left, width);
  const Index bottom = std::clamp<Index>(floor_div(around.high.y, kUnitsPerPixel) + 1, top, height);
  return {left, top, right - left, bottom - top};
}

}  // namespace thinbench::scene_detail
