// Drawn photographs, with soft outlines, uneven light and noise, under default options.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/filled_image.hpp"
#include "support/made_image.hpp"
#include "typed.hpp"

namespace thinbench {
namespace {

/// A disc whose outline is one pixel wide: pixels there mix both levels.
void draw_disc(ByteImage& image, double centre_x, double centre_y, double radius, int level) {
  image = image_by(image.width(), image.height(), [&](Index x, Index y) {
    const double distance = std::hypot(double(x) - centre_x, double(y) - centre_y);
    const double inside = std::clamp(radius + 0.5 - distance, 0.0, 1.0);
    return std::lround(inside * level + (1 - inside) * image.at(x, y));
  });
}

void draw_box(ByteImage& image, Index left, Index top, Index width, Index height, int level) {
  const ImageView& all = image.view();
  fill({all.row(top) + left, width, height, all.stride}, static_cast<std::uint8_t>(level));
}

/// Adds noise of at most `most` levels, and light that falls by `fall` levels from left to right.
ByteImage photograph(const ByteImage& drawing, int most, int fall) {
  const ByteImage noise = grey_noise_image(drawing.width(), drawing.height(), 0,
                                           static_cast<std::uint8_t>(2 * most), 5);
  return image_by(drawing.width(), drawing.height(), [&](Index x, Index y) {
    const Index light = most + fall * x / drawing.width();
    return std::clamp<Index>(drawing.at(x, y) + noise.at(x, y) - light, 0, 255);
  });
}

/// A dark plate with seven holes and six dark discs on white paper.
ByteImage plate_and_discs() {
  ByteImage image = filled_image(400, 300, 240);
  draw_box(image, 40, 40, 320, 120, 30);
  for (int i = 0; i < 7; ++i) draw_disc(image, 70 + 43 * i, 70 + 20 * (i % 3), 9 + i % 4, 240);
  for (int i = 0; i < 6; ++i) draw_disc(image, 50 + 60 * i, 230, 12 + i, 50);
  return photograph(image, 12, 20);
}

/// Six dark parts on a bright table, surrounded by a dark room.
ByteImage parts_on_a_table() {
  ByteImage image = filled_image(400, 300, 15);
  draw_box(image, 50, 50, 300, 210, 220);
  for (int i = 0; i < 6; ++i) draw_disc(image, 100 + 100 * (i % 3), 100 + 110 * (i / 3), 30, 40);
  return photograph(image, 10, 0);
}

/// 24 bright coins on dark cloth in light that falls so much that no level separates them all.
ByteImage coins() {
  ByteImage image = filled_image(384, 300, 115);
  for (int i = 0; i < 24; ++i) {
    draw_disc(image, 40 + 60 * (i % 6), 45 + 70 * (i / 6), 18 + i % 5, 215);
  }
  return photograph(image, 45, 100);
}

ProgramRun holes(const ByteImage& image, const std::string& options) {
  write_grey("photograph.png", image.view());
  return typed("holes photograph.png " + options);
}

void expect_found(const ByteImage& image, const char* found, const std::string& foreground) {
  const ProgramRun run = holes(image, "--min-area 20");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out.substr(0, run.out.find('\n')), found);
  EXPECT_EQ(run.err.find("note: photograph.png: foreground is " + foreground), 0U) << run.err;
  EXPECT_EQ(run.err.find("warning: "), std::string::npos) << run.err;
}

using Photograph = Commands;

TEST_F(Photograph, of_a_dark_plate_on_paper_has_its_seven_holes_by_default) {
  expect_found(plate_and_discs(), "7 objects, 7 holes", "dark");
}

TEST_F(Photograph, of_a_bright_table_in_a_dark_room_is_one_object_by_default) {
  expect_found(parts_on_a_table(), "1 object, 6 holes", "bright");
}

TEST_F(Photograph, in_light_that_falls_brings_a_warning_unless_the_threshold_is_given) {
  const ByteImage image = coins();
  expect_holds(holes(image, "").err, "warning: ");
  const ProgramRun chosen = holes(image, "--threshold 140 --foreground bright --min-area 100");
  EXPECT_EQ(chosen.status, 0);
  EXPECT_EQ(chosen.err, "");
}

}  // namespace
}  // namespace thinbench
