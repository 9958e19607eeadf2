// Graphs that are known before they are drawn are what is found in the drawing: the same nodes at
// the same places, the same lines between them, of the same lengths.
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "graph/recovery.hpp"

namespace thinbench {
namespace {

/// Lines of a grid; those of an open one go on beyond the last crossing.
Drawing grid(int columns, int rows, int spacing, bool is_open) {
  const int margin = is_open ? 1 : 0;
  const int width = columns - 1 + 2 * margin;
  const int height = rows - 1 + 2 * margin;
  Drawing drawing(width * spacing + 1, height * spacing + 1);
  for (int y = margin; y <= height - margin; ++y) {
    for (int x = 0; x < width; ++x)
      drawing.line({x * spacing, y * spacing}, {(x + 1) * spacing, y * spacing});
  }
  for (int x = margin; x <= width - margin; ++x) {
    for (int y = 0; y < height; ++y)
      drawing.line({x * spacing, y * spacing}, {x * spacing, (y + 1) * spacing});
  }
  return drawing;
}

TEST(DrawnGraphs, of_grids_are_recovered) {
  Recovery recover;
  for (int columns = 2; columns <= 6; ++columns) {
    for (int rows = 2; rows <= 6; ++rows) {
      for (const int spacing : {2, 3, 7}) {
        for (const bool is_open : {false, true}) {
          const Drawing drawing = grid(columns, rows, spacing, is_open);
          ASSERT_TRUE(drawing.is_held());
          recover(drawing);
        }
      }
    }
  }
  EXPECT_EQ(recover.count(), kGrids);
}

/// Points of a grid, and some of the lines between them.
Drawing maze(int spacing, std::mt19937& random) {
  constexpr int columns = 9;
  constexpr int rows = 7;
  Drawing drawing(columns * spacing, rows * spacing);
  const auto lines_in_8 = 2 + random() % 5;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const Pixel at = {x * spacing, y * spacing};
      drawing.point(at);
      if (x + 1 < columns && random() % 8 < lines_in_8) drawing.line(at, {at.x + spacing, at.y});
      if (y + 1 < rows && random() % 8 < lines_in_8) drawing.line(at, {at.x, at.y + spacing});
    }
  }
  return drawing;
}

TEST(DrawnGraphs, of_mazes_with_single_pixels_and_closed_lines_are_recovered) {
  Recovery recover;
  std::mt19937 random(1);
  for (int i = 0; i < kMazes; ++i) {
    const Drawing drawing = maze(2 + i % 4, random);
    ASSERT_TRUE(drawing.is_held());
    recover(drawing);
  }
  EXPECT_EQ(recover.count(), kMazes);
}

/// Grows from point to point; a line that the raster would not hold is not drawn.
Drawing tree(std::mt19937& random) {
  constexpr int cells = 7;
  constexpr int cell = 16;
  std::vector<Pixel> places;
  for (int i = 0; i < cells * cells; ++i) {
    const auto jitter = [&] { return 4 + static_cast<int>(random() % 9); };
    const int x = jitter();
    places.push_back({i % cells * cell + x, i / cells * cell + jitter()});
  }
  Drawing drawing(cells * cell, cells * cell);
  std::vector<std::size_t> reached = {random() % places.size()};
  for (int attempt = 0; attempt < 400; ++attempt) {
    const std::size_t from = reached[random() % reached.size()];
    const std::size_t to = random() % places.size();
    const bool is_new = std::find(reached.begin(), reached.end(), to) == reached.end();
    if (!is_new || across(places[from], places[to]) > 2 * cell) continue;
    Drawing more = drawing;
    more.line(places[from], places[to]);
    if (!more.is_held()) continue;
    drawing = std::move(more);
    reached.push_back(to);
  }
  return drawing;
}

TEST(DrawnGraphs, of_trees_at_any_angles_are_recovered) {
  Recovery recover;
  std::mt19937 random(2);
  while (recover.count() < kTrees) {
    const Drawing drawing = tree(random);
    ASSERT_GE(drawing.points(), 8U);
    recover(drawing);
  }
}

/// Bresenham's circle (CACM 20(2), 1977), counterclockwise, closed.
Path circle(Pixel centre, int radius) {
  Path path;
  int error = 1 - radius;
  for (int x = radius, y = 0; y <= x; ++y) {
    for (const auto& [a, b] : {std::pair(x, y), {y, x}}) {
      for (const auto& [u, v] : {std::pair(a, b), {-a, b}, {a, -b}, {-a, -b}})
        path.push_back({u, v});
    }
    error += error < 0 ? 2 * y + 3 : 2 * (y - --x) + 5;
  }
  const auto angle = [](Pixel p) { return std::atan2(p.y, p.x); };
  std::sort(path.begin(), path.end(), [&](Pixel a, Pixel b) { return angle(a) < angle(b); });
  path.erase(std::unique(path.begin(), path.end()), path.end());
  path.push_back(path.front());
  for (Pixel& p : path) p = {p.x + centre.x, p.y + centre.y};
  return path;
}

TEST(DrawnGraphs, of_circles_are_cycles) {
  Recovery recover;
  for (int radius = 1; radius <= kCircles; ++radius) {
    Drawing drawing(2 * radius + 1, 2 * radius + 1);
    drawing.path(circle({radius, radius}, radius));
    ASSERT_TRUE(drawing.is_held());
    ASSERT_EQ(drawing.truth().nodes.at(0).kind, NodeKind::cycle);
    recover(drawing);
  }
  EXPECT_EQ(recover.count(), kCircles);
}

/// A circle with lines from its four outermost points to its centre and away from it, as bits of
/// `spokes` and `tails` say.
Drawing wheel(int radius, unsigned spokes, unsigned tails) {
  const int middle = radius + 9;
  Drawing drawing(2 * middle + 1, 2 * middle + 1);
  drawing.path(circle({middle, middle}, radius));
  for (unsigned side = 0; side < 4; ++side) {
    const int x = side % 2 == 0 ? 1 - static_cast<int>(side) : 0;
    const int y = side % 2 == 1 ? 2 - static_cast<int>(side) : 0;
    const auto at = [&](int distance) {
      return Pixel{middle + x * distance, middle + y * distance};
    };
    if ((spokes >> side & 1) != 0) drawing.line(at(radius), at(0));
    if ((tails >> side & 1) != 0) drawing.line(at(radius), at(middle));
  }
  return drawing;
}

TEST(DrawnGraphs, of_circles_with_spokes_and_tails_are_recovered) {
  Recovery recover;
  for (int radius = 5; radius < 45; ++radius) {
    for (const auto& [spokes, tails] :
         {std::pair(0U, 1U), {0U, 0b1101U}, {0b0101U, 0U}, {0b1111U, 0b1011U}}) {
      const Drawing drawing = wheel(radius, spokes, tails);
      ASSERT_TRUE(drawing.is_held());
      recover(drawing);
    }
  }
  EXPECT_EQ(recover.count(), kWheels);
}

}  // namespace
}  // namespace thinbench
