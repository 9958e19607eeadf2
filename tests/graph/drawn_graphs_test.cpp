// Graphs that are known before they are drawn are what is found in the drawing: the same nodes at
// the same places, the same lines between them, of the same lengths.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "graph/drawing.hpp"
#include "support/made_image.hpp"

namespace thinbench {
namespace {

using Node = std::pair<NodeKind, Place>;
/// The nodes of a line, and its straight and its diagonal steps.
using Line = std::tuple<Place, Place, std::int32_t, std::int32_t>;

Line line_between_places(Place a, Place b, std::int32_t straight, std::int32_t diagonal) {
  return {std::min(a, b), std::max(a, b), straight, diagonal};
}

struct Found {
  std::vector<Node> nodes;
  std::vector<Line> lines;

  void sort() {
    std::sort(nodes.begin(), nodes.end());
    std::sort(lines.begin(), lines.end());
  }
};

Found drawn_in(const Truth& truth) {
  Found all;
  for (const TrueNode& node : truth.nodes) all.nodes.push_back({node.kind, place_of(node.at)});
  for (const TrueEdge& edge : truth.edges) {
    all.lines.push_back(
        line_between_places(place_of(edge.from), place_of(edge.to), edge.straight, edge.diagonal));
  }
  all.sort();
  return all;
}

/// All nodes of a drawing that the raster holds are single pixels.
Found found_in(const Graph& graph, std::int32_t left) {
  Found all;
  for (const GraphNode& node : graph.nodes) {
    EXPECT_EQ(node.pixel_count, 1U);
    const Pixel at = graph.pixels_of(node).front();
    all.nodes.push_back({node.kind, {at.y, at.x - left}});
  }
  for (const auto& edge : graph.edges) {
    const auto [horizontal, vertical, diagonal] = edge.steps;
    all.lines.push_back(line_between_places(all.nodes[edge.from].second, all.nodes[edge.to].second,
                                            static_cast<int>(horizontal + vertical),
                                            static_cast<int>(diagonal)));
  }
  all.sort();
  return all;
}

/// Expects the graphs of drawings to be what was drawn, and counts them.
class Recovery {
 public:
  /// Beside more background than the drawing has, so that lines meet the ends of words anywhere.
  void operator()(const Drawing& drawing) {
    const std::int32_t left = 13 * count_++ % 67;
    const ConstImageView image = drawing.image();
    const ByteImage placed = image_by(left + image.width, image.height, [&](Index x, Index y) {
      return x < left ? 0 : image.row(y)[x - left];
    });
    const Found found = found_in(skeleton_graph(placed.view()), left);
    const Found drawn = drawn_in(drawing.truth());
    EXPECT_EQ(found.nodes, drawn.nodes) << "drawing " << count_;
    EXPECT_EQ(found.lines, drawn.lines) << "drawing " << count_;
  }

  [[nodiscard]] int count() const { return count_; }

 private:
  int count_ = 0;
};

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
  for (int i = 0; i < 150; ++i) {
    const Drawing drawing = maze(2 + i % 4, random);
    ASSERT_TRUE(drawing.is_held());
    recover(drawing);
  }
  EXPECT_EQ(recover.count(), 150);
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
  while (recover.count() < 200) {
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
  for (int radius = 1; radius <= 60; ++radius) {
    Drawing drawing(2 * radius + 1, 2 * radius + 1);
    drawing.path(circle({radius, radius}, radius));
    ASSERT_TRUE(drawing.is_held());
    ASSERT_EQ(drawing.truth().nodes.at(0).kind, NodeKind::cycle);
    recover(drawing);
  }
  EXPECT_EQ(recover.count(), 60);
}

constexpr int kArm = 30;  // pixels

/// Lines from the middle in these directions.
Drawing star(const std::vector<Pixel>& directions) {
  constexpr Pixel middle = {kArm, kArm};
  Drawing drawing(2 * kArm + 1, 2 * kArm + 1);
  for (const auto& [x, y] : directions) {
    const int times = kArm / std::max(std::abs(x), std::abs(y));
    drawing.line(middle, {middle.x + times * x, middle.y + times * y});
  }
  return drawing;
}

/// Of all slopes m / n with m, n <= 5 (the Farey sequence and its mirror images).
std::vector<Pixel> all_directions() {
  std::vector<Pixel> found;
  for (std::int32_t y = -5; y <= 5; ++y) {
    for (std::int32_t x = -5; x <= 5; ++x) {
      if (std::gcd(x, y) == 1) found.push_back({x, y});
    }
  }
  return found;
}

// At a small angle pixels of two lines touch beyond the first ones: the raster does not hold them.
TEST(DrawnGraphs, of_two_lines_that_cross_are_recovered_at_every_angle_that_the_raster_holds) {
  Recovery recover;
  for (const Pixel a : all_directions()) {
    for (const Pixel b : all_directions()) {
      const Drawing drawing = star({a, b, {-a.x, -a.y}, {-b.x, -b.y}});
      if (drawing.is_held()) recover(drawing);
    }
  }
  EXPECT_GE(recover.count(), 500);
}

TEST(DrawnGraphs, of_stars_with_three_to_five_arms_are_recovered) {
  Recovery recover;
  std::mt19937 random(4);
  const std::vector<Pixel> all = all_directions();
  while (recover.count() < 200) {
    std::vector<Pixel> directions(3 + random() % 3);
    for (Pixel& direction : directions) direction = all[random() % all.size()];
    const Drawing drawing = star(directions);
    if (drawing.is_held()) recover(drawing);
  }
}

}  // namespace
}  // namespace thinbench
