#include "scene/layout.hpp"

namespace thinbench::scene_detail {
namespace {

/// Spur gear with a hexagonal bore and a ring of six round holes.
PartShape spur_gear() {
  const Point centre = px(230, 76);
  PartShape part{
      {"gear", gear(centre, 24, px(51), px(60))}, {{"hexagon", hexagon(centre, px(14))}}, {5, -3}};
  for (int i = 0; i < 6; ++i) {
    part.holes.push_back({"circle", circle(on_circle(centre, px(34), 16 * i + 8), px(9))});
  }
  return part;
}

PartShape pinion() {
  const Point centre = px(444, 238);
  return {{"gear", gear(centre, 16, px(33), px(41))},
          {{"square", rectangle({centre, px(10), px(10), 0, {3, 4}})}},
          {5, 4}};
}

PartShape flange_plate() {
  return {box("plate", px(14, 14), px(160, 124), px(14)),
          {disc(32, 32, 15), disc(142, 32, 15), disc(32, 106, 15), disc(142, 106, 15),
           disc(87, 69, 46), square(40, 69, 16), square(134, 69, 16)},
          {2, 5}};
}

PartShape u_bracket() {
  return {cut_out("u_bracket", {{304, 14, 4},
                                {328, 14, 4},
                                {328, 108, 8},
                                {380, 108, 8},
                                {380, 14, 4},
                                {404, 14, 4},
                                {404, 136, 18},
                                {304, 136, 18}}),
          {disc(316, 28, 11), disc(392, 28, 11), slot(354, 122, 44, 10)},
          {3, -4}};
}

PartShape l_bracket() {
  return {cut_out("l_bracket", {{248, 152, 6},
                                {276, 152, 6},
                                {276, 228, 10},
                                {344, 228, 6},
                                {344, 256, 6},
                                {248, 256, 12}}),
          {disc(262, 168, 12), disc(262, 198, 12), slot(310, 242, 40, 12)},
          {4, -3}};
}

PartShape slotted_plate() {
  return {box("plate", px(358, 152), px(392, 268), px(6)),
          {slot(375, 170, 20, 10), slot(375, 190, 20, 10), slot(375, 210, 20, 10),
           slot(375, 230, 20, 10), slot(375, 250, 20, 10)},
          {-5, 5}};
}

PartShape grid_plate() {
  PartShape part{box("plate", px(14, 266), px(122, 398), px(5)), {}, {-3, -2}};
  for (int y = 292; y <= 372; y += 40) {
    for (int x = 36; x <= 100; x += 32) part.holes.push_back(square(x, y, 18));
  }
  return part;
}

PartShape tilted_link() {
  constexpr Point axis = {4, -3};
  return {stadium("link", px(194, 306), 140, 40, axis),
          {slot(194, 306, 40, 10, axis), disc(154, 336, 18), disc(234, 276, 18)},
          {3, 5}};
}

PartShape gusset() {
  return {cut_out("gusset", {{262, 286}, {284, 286}, {364, 370}, {364, 398}, {262, 398}}),
          {disc(292, 366, 34), disc(336, 384, 11), disc(274, 308, 11)},
          {-4, -4}};
}

/// A round pin that lies parallel to the long side of the gusset.
PartShape tilted_pin(Point centre, Unit half_length, Unit half_width) {
  constexpr Point kAxis = {20, 21};
  constexpr Unit kAxisLength = 29;
  return {{"pin", rectangle({centre, half_length * kAxisLength, half_width * kAxisLength,
                             half_width * kAxisLength, kAxis})},
          {},
          {}};
}

PartShape serpentine() {
  return {band("wire",
               {px(398, 292), px(490, 292), px(490, 308), px(400, 308), px(400, 324), px(490, 324),
                px(490, 340), px(398, 340)},
               3, 8),
          {},
          {19, 13}};
}

PartShape z_rod() {
  return {
      band("rod", {px(402, 388), px(446, 388), px(446, 360), px(488, 360)}, 11, 14), {}, {13, 19}};
}

}  // namespace

std::vector<PartShape> parts_layout() {
  constexpr Point kRight = {1, 0};
  constexpr Point kDown = {0, 1};
  return {
      flange_plate(),
      spur_gear(),
      u_bracket(),
      {stadium("link", px(354, 58), 76, 24, kDown), {disc(354, 34, 11), disc(354, 82, 11)}, {4, 2}},
      {stadium("bar", px(448, 98), 164, 60, kDown), {}, {3, 5}},
      {disc(74, 194, 114, "washer"), {disc(74, 194, 56)}, {5, 5}},
      {{"hex_nut", hexagon(px(188, 194), px(46))}, {disc(188, 194, 46)}, {5, 5}},
      l_bracket(),
      {disc(316, 186, 56, "washer"), {disc(316, 186, 26)}, {-5, 2}},
      slotted_plate(),
      pinion(),
      grid_plate(),
      tilted_link(),
      gusset(),
      tilted_pin(px(340, 318), 53, 6),
      tilted_pin(px(354, 306), 46, 2),
      serpentine(),
      z_rod(),
      {band("wire", {px(489, 22), px(489, 182)}, 2, 0), {}, {3, 5}},
      {stadium("pin", px(166, 374), 62, 14, kRight), {}, {-3, 3}},
      {stadium("pin", px(166, 392), 62, 6, kRight), {}, {3, 5}},
      {disc(228, 374, 46, "washer"), {disc(228, 374, 20)}, {2, -3}},
  };
}

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

/// Its lower row of holes meets the image border.
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

PartShape steep_link() {
  constexpr Point kAxis = {4, 3};
  return {stadium("link", px(340, 92), 150, 40, kAxis),
          {disc(296, 59, 18), disc(384, 125, 18), slot(340, 92, 50, 10, kAxis)},
          {3, 5}};
}

PartShape small_l_bracket() {
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

std::vector<PartShape> border_touching_layout() {
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
      steep_link(),
      small_l_bracket(),
      {disc(206, 184, 104, "washer"), {disc(206, 184, 48)}, {-5, 2}},
      {{"hex_nut", hexagon(px(326, 204), px(40))}, {disc(326, 204, 40)}, {4, 1}},
      {disc(334, 334, 56, "washer"), {disc(334, 334, 24)}, {2, -4}},
  };
}

}  // namespace thinbench::scene_detail
