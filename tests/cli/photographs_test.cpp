// Drawn photographs, with soft outlines, uneven light and noise, under default options.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/filled_image.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

/// A disc whose outline is one pixel wide: pixels there mix both levels.
void draw_disc(ByteImage& image, double centre_x, double centre_y, double radius, int level) {
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      const double distance = std::hypot(double(x) - centre_x, double(y) - centre_y);
      const double inside = std::clamp(radius + 0.5 - distance, 0.0, 1.0);
      image.at(x, y) =
          static_cast<std::uint8_t>(std::lround(inside * level + (1 - inside) * image.at(x, y)));
    }
  }
}

void draw_box(ByteImage& image, Index left, Index top, Index width, Index height, int level) {
  for (Index y = top; y < top + height; ++y) {
    for (Index x = left; x < left + width; ++x) image.at(x, y) = static_cast<std::uint8_t>(level);
  }
}

/// Adds noise of at most `most` levels, and light that falls by `fall` levels from left to right.
ByteImage photograph(const ByteImage& drawing, int most, int fall) {
  const ByteImage noise = grey_noise_image(drawing.width(), drawing.height(), 0,
                                           static_cast<std::uint8_t>(2 * most), 5);
  ByteImage result(drawing.width(), drawing.height());
  for (Index y = 0; y < result.height(); ++y) {
    for (Index x = 0; x < result.width(); ++x) {
      const Index level =
          drawing.at(x, y) + noise.at(x, y) - most - fall * x / std::max<Index>(result.width(), 1);
      result.at(x, y) = static_cast<std::uint8_t>(std::clamp<Index>(level, 0, 255));
    }
  }
  return result;
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

class Photograph : public testing::Test {
 protected:
  [[nodiscard]] ProgramRun holes(const ByteImage& image, std::vector<std::string> options) const {
    write_grey(path, image.view());
    options.insert(options.begin(), {"holes", path});
    return run_with(options);
  }

  void expect_found(const ByteImage& image, const char* found, const char* foreground) const {
    const ProgramRun run = holes(image, {"--min-area", "20"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out.substr(0, run.out.find('\n')), found);
    EXPECT_EQ(run.err.find("note: " + path + ": foreground is " + foreground), 0U) << run.err;
    EXPECT_EQ(run.err.find("warning: "), std::string::npos) << run.err;
  }

  TemporaryDirectory directory;
  std::string path = directory.file("photograph.png");
};

TEST_F(Photograph, of_a_dark_plate_on_paper_has_its_seven_holes_by_default) {
  expect_found(plate_and_discs(), "7 objects, 7 holes", "dark");
}

TEST_F(Photograph, of_a_bright_table_in_a_dark_room_is_one_object_by_default) {
  expect_found(parts_on_a_table(), "1 object, 6 holes", "bright");
}

TEST_F(Photograph, in_light_that_falls_brings_a_warning_unless_the_threshold_is_given) {
  const ByteImage image = coins();
  EXPECT_NE(holes(image, {}).err.find("warning: "), std::string::npos);
  const ProgramRun chosen =
      holes(image, {"--threshold", "140", "--foreground", "bright", "--min-area", "100"});
  EXPECT_EQ(chosen.status, 0);
  EXPECT_EQ(chosen.err, "");
}

}  // namespace
}  // namespace thinbench
