#include "sweeps/input.hpp"

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "scene/scene.hpp"

namespace thinbench {
namespace {

double dark_share(const ByteImage& image) {
  Index dark = 0;
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) dark += image.at(x, y) != 0 ? 1 : 0;
  }
  return static_cast<double>(dark) / static_cast<double>(image.width() * image.height());
}

TEST(SweepInput, scene_is_laid_out_like_tiles_of_any_width) {
  const Scene scene = render_scene();
  for (const InputKind kind : {InputKind::binary, InputKind::grey}) {
    const ByteImage& tile = kind == InputKind::grey ? scene.grey : scene.binary;
    const ByteImage image = make_input({Picture::scene, 1023, 513}, kind);
    for (Index y = 0; y < 513; y += 7) {
      for (Index x = 0; x < 1023; ++x) ASSERT_EQ(image.at(x, y), tile.at(x % 510, y % 412));
    }
  }
}

TEST(SweepInput, noise_has_the_density_and_the_blocks_it_is_asked_for) {
  const ByteImage image = make_input({Picture::noise, 512, 512, 4, 30}, InputKind::binary);
  EXPECT_NEAR(dark_share(image), 0.3, 0.02);
  for (Index x = 0; x < 512; ++x) ASSERT_EQ(image.at(x, 9), image.at(x / 4 * 4, 8));
  EXPECT_EQ(dark_share(make_input({Picture::noise, 64, 64, 1, 0}, InputKind::binary)), 0);
  EXPECT_EQ(dark_share(make_input({Picture::noise, 64, 64, 1, 100}, InputKind::binary)), 1);
}

TEST(SweepInput, squares_of_any_side_are_a_quarter_of_the_image_and_touch_no_frame) {
  for (const Index side : {4, 64, 256}) {
    const ByteImage image = make_input({Picture::squares, 512, 512, side}, InputKind::binary);
    EXPECT_EQ(dark_share(image), 0.25) << side;
    EXPECT_EQ(image.at(0, 0) + image.at(511, 511), 0);
    EXPECT_EQ(image.at(side / 2, side / 2) + image.at(side / 2 + side - 1, side / 2), 510);
    EXPECT_EQ(image.at(side / 2 + side, side / 2), 0);
  }
}

TEST(SweepInput, there_is_no_grey_noise) {
  EXPECT_THROW(static_cast<void>(make_input({Picture::noise, 8, 8, 1, 50}, InputKind::grey)),
               std::logic_error);
}

TEST(SweepInputStore, gives_the_same_image_again_after_it_made_room) {
  InputStore store(3 * 64 * 64);
  const SweepInput first{Picture::noise, 64, 64, 1, 50};
  const ByteImage before = copy_of(store.get(first, InputKind::binary).view());
  for (int percent = 10; percent < 50; percent += 10) {
    store.get({Picture::noise, 64, 64, 1, percent}, InputKind::binary);
    EXPECT_LE(store.bytes(), 3 * 64 * 64);
  }
  EXPECT_TRUE(equal(store.get(first, InputKind::binary).view(), before.view()));
}

}  // namespace
}  // namespace thinbench
