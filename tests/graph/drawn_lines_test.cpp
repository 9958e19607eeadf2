// Spirals and letters: as drawn_graphs_test.cpp.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "graph/recovery.hpp"

namespace thinbench {
namespace {

Drawing round_spiral(int pitch, int turns) {
  const int middle = pitch * turns + 6;
  Drawing drawing(2 * middle + 1, 2 * middle + 1);
  Pixel last = {-1, -1};
  for (int i = 0; i <= 16 * turns; ++i) {
    const double angle = i * std::numbers::pi / 8;
    const double radius = 5 + pitch * i / 16.0;
    const Pixel next = {middle + static_cast<int>(std::lround(radius * std::cos(angle))),
                        middle + static_cast<int>(std::lround(radius * std::sin(angle)))};
    if (i > 0) drawing.line(last, next);
    last = next;
  }
  return drawing;
}

Drawing square_spiral(int pitch, int turns) {
  const int middle = pitch * (turns + 1);
  Drawing drawing(2 * middle + 1, 2 * middle + 1);
  Pixel at = {middle, middle};
  for (int side = 0; side < 4 * turns; ++side) {
    const int length = pitch * (side / 2 + 1) * (side % 4 < 2 ? 1 : -1);
    const Pixel next = side % 2 == 0 ? Pixel{at.x + length, at.y} : Pixel{at.x, at.y + length};
    drawing.line(at, next);
    at = next;
  }
  return drawing;
}

TEST(DrawnGraphs, of_spirals_are_one_line) {
  Recovery recover;
  for (int turns = 1; turns <= 5; ++turns) {
    for (int pitch = 2; pitch <= 10; ++pitch) {
      for (const Drawing& drawing : {square_spiral(pitch, turns), round_spiral(pitch + 2, turns)}) {
        ASSERT_TRUE(drawing.is_held());
        ASSERT_EQ(drawing.truth().edges.size(), 1U);
        recover(drawing);
      }
    }
  }
  EXPECT_EQ(recover.count(), kSpirals);
}

struct Letter {
  char name;
  std::vector<Path> strokes;  // 6 units high
  int ends;
  int junctions;
};

const std::vector<Letter> kAlphabet = {
    {'A', {{{0, 6}, {0, 3}, {0, 2}, {2, 0}, {4, 2}, {4, 3}, {4, 6}}, {{0, 3}, {4, 3}}}, 2, 2},
    {'B',
     {{{0, 0}, {3, 0}, {4, 1}, {4, 2}, {3, 3}, {0, 3}, {0, 0}},
      {{3, 3}, {4, 4}, {4, 5}, {3, 6}, {0, 6}, {0, 3}}},
     0,
     2},
    {'C', {{{4, 1}, {3, 0}, {1, 0}, {0, 1}, {0, 5}, {1, 6}, {3, 6}, {4, 5}}}, 2, 0},
    {'D', {{{0, 0}, {3, 0}, {4, 1}, {4, 5}, {3, 6}, {0, 6}, {0, 0}}}, 0, 0},
    {'E', {{{4, 0}, {0, 0}, {0, 3}, {0, 6}, {4, 6}}, {{0, 3}, {3, 3}}}, 3, 1},
    {'F', {{{4, 0}, {0, 0}, {0, 3}, {0, 6}}, {{0, 3}, {3, 3}}}, 3, 1},
    {'H', {{{0, 0}, {0, 3}, {0, 6}}, {{4, 0}, {4, 3}, {4, 6}}, {{0, 3}, {4, 3}}}, 4, 2},
    {'K', {{{0, 0}, {0, 3}, {0, 6}}, {{0, 3}, {1, 3}, {4, 0}}, {{1, 3}, {4, 6}}}, 4, 2},
    {'O', {{{1, 0}, {3, 0}, {4, 1}, {4, 5}, {3, 6}, {1, 6}, {0, 5}, {0, 1}, {1, 0}}}, 0, 0},
    {'P', {{{0, 6}, {0, 3}, {0, 0}, {3, 0}, {4, 1}, {4, 2}, {3, 3}, {0, 3}}}, 1, 1},
    {'R',
     {{{0, 6}, {0, 3}, {0, 0}, {3, 0}, {4, 1}, {4, 2}, {3, 3}, {0, 3}}, {{3, 3}, {4, 4}, {4, 6}}},
     2,
     2},
    {'S',
     {{{4, 1},
       {3, 0},
       {1, 0},
       {0, 1},
       {0, 2},
       {1, 3},
       {3, 3},
       {4, 4},
       {4, 5},
       {3, 6},
       {1, 6},
       {0, 5}}},
     2,
     0},
    {'T', {{{0, 0}, {2, 0}, {4, 0}}, {{2, 0}, {2, 6}}}, 3, 1},
    {'X', {{{0, 0}, {3, 3}, {6, 6}}, {{6, 0}, {3, 3}, {0, 6}}}, 4, 1},
    {'Y', {{{0, 0}, {2, 2}, {2, 6}}, {{4, 0}, {2, 2}}}, 3, 1},
    {'4', {{{0, 0}, {0, 3}, {4, 3}, {5, 3}}, {{4, 0}, {4, 3}, {4, 6}}}, 4, 1},
    {'6',
     {{{3, 0}, {1, 0}, {0, 1}, {0, 3}, {0, 5}, {1, 6}, {3, 6}, {4, 5}, {4, 4}, {3, 3}, {0, 3}}},
     1,
     1},
    {'8',
     {{{1, 0}, {3, 0}, {4, 1}, {4, 2}, {3, 3}, {1, 3}, {0, 2}, {0, 1}, {1, 0}},
      {{3, 3}, {4, 4}, {4, 5}, {3, 6}, {1, 6}, {0, 5}, {0, 4}, {1, 3}}},
     0,
     2},
    {'9',
     {{{1, 6}, {3, 6}, {4, 5}, {4, 3}, {4, 1}, {3, 0}, {1, 0}, {0, 1}, {0, 2}, {1, 3}, {4, 3}}},
     1,
     1}};

Drawing letter(const Letter& from, int unit) {
  Drawing drawing(6 * unit + 1, 6 * unit + 1);
  for (const Path& stroke : from.strokes) {
    for (std::size_t i = 1; i < stroke.size(); ++i) {
      const auto [x, y] = stroke[i];
      drawing.line({stroke[i - 1].x * unit, stroke[i - 1].y * unit}, {x * unit, y * unit});
    }
  }
  return drawing;
}

std::ptrdiff_t nodes_of(const Drawing& drawing, NodeKind kind) {
  const std::vector<TrueNode> nodes = drawing.truth().nodes;
  return std::count_if(nodes.begin(), nodes.end(),
                       [=](const TrueNode& node) { return node.kind == kind; });
}

TEST(DrawnGraphs, of_letters_are_recovered) {
  Recovery recover;
  for (const Letter& from : kAlphabet) {
    for (int unit = 2; unit < 2 + kScales; ++unit) {
      const Drawing drawing = letter(from, unit);
      ASSERT_TRUE(drawing.is_held()) << from.name;
      ASSERT_EQ(nodes_of(drawing, NodeKind::end), from.ends) << from.name;
      ASSERT_EQ(nodes_of(drawing, NodeKind::junction), from.junctions) << from.name;
      recover(drawing);
    }
  }
  EXPECT_EQ(recover.count(), kLetters);
}

}  // namespace
}  // namespace thinbench
