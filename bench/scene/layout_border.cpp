#include "scene/drafting.hpp"
#include "scene/layout.hpp"

namespace thinbench::scene_detail {
namespace {

/// Legs run out of the image at the top, so the channel between them is open background.
PartShape u_bracket_over_the_top() {
  return {cut_out("u_bracket", {{156, -24, 4},
                                {184, -24, 4},
                                {184, 70, 10},
                                {244, 70, 10},
                                {244, -24, 4},
                                {272, -24, 4},
                                {272, 100, 18},
                                {156, 100, 18}}),
          {disc(170, 24, 12), disc(258, 24, 12), slot(214, 86, 48, 12)},
          {5, 2}};
}

/// Half of the gear lies outside, and with it half of the bore and one of the round holes.
PartShape gear_over_the_right() {
  const Point centre = px(496, 106);
  PartShape part{
      {"gear", gear(centre, 24, px(73), px(84))}, {{"circle", circle(centre, px(20))}}, {}};
  for (int i = 0; i < 6; ++i) {
    part.holes.push_back({"circle", circle(on_circle(centre, px(50), 16 * i), px(11))});
  }
  return part;
}

/// Its lower row of holes meets the frame.
PartShape plate_over_the_bottom() {
  return {box("plate", px(70, 322), px(216, 446), px(12)),
          {disc(92, 344, 16), disc(194, 344, 16), square(143, 356, 30), disc(92, 412, 16),
           disc(194, 412, 16), slot(143, 392, 60, 14)},
          {3, 5}};
}

PartShape flush_plate() {
  return {box("plate", px(432, 222), px(510, 296), px(0)),
          {disc(452, 242, 16), disc(490, 242, 16), slot(471, 274, 46, 14)},
          {}};
}

PartShape tilted_link() {
  constexpr Point kAxis = {4, 3};
  return {stadium("link", px(340, 92), 150, 40, kAxis),
          {disc(296, 59, 18), disc(384, 125, 18), slot(340, 92, 50, 10, kAxis)},
          {3, 5}};
}

PartShape l_bracket() {
  return {cut_out("l_bracket", {{250, 318, 6},
                                {278, 318, 6},
                                {278, 372, 10},
                                {366, 372, 6},
                                {366, 398, 6},
                                {250, 398, 12}}),
          {disc(264, 334, 12), slot(326, 385, 44, 10)},
          {4, -3}};
}

}  // namespace

std::vector<PartShape> frame_touching_layout() {
  constexpr Point kRight = {1, 0};
  constexpr Point kDown = {0, 1};
  return {
      {disc(48, 42, 150, "washer"), {disc(48, 42, 64)}, {5, 5}},
      u_bracket_over_the_top(),
      gear_over_the_right(),
      plate_over_the_bottom(),
      flush_plate(),
      {{"hex_nut", hexagon(px(478, 386), px(62))}, {disc(478, 386, 40)}, {5, 5}},
      {stadium("bar", px(44, 206), 180, 60, kRight), {}, {3, 5}},
      {band("wire", {px(-10, 260), px(384, 260), px(384, 308), px(520, 308)}, 3, 20), {}, {0, 13}},
      {stadium("pin", px(27, 372), 128, 14, kDown), {}, {3, 3}},
      tilted_link(),
      l_bracket(),
      {disc(206, 184, 104, "washer"), {disc(206, 184, 48)}, {-5, 2}},
      {{"hex_nut", hexagon(px(326, 204), px(40))}, {disc(326, 204, 40)}, {4, 1}},
      {disc(334, 334, 56, "washer"), {disc(334, 334, 24)}, {2, -4}},
  };
}

}  // namespace thinbench::scene_detail
