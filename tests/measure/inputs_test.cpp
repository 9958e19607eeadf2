#include "measure/inputs.hpp"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "images/image_file.hpp"
#include "scene/scene.hpp"
#include "support/rejection.hpp"
#include "support/temporary_directory.hpp"
#include "support/usage.hpp"

namespace thinbench {
namespace {

using Names = std::vector<std::string>;

/// The names that inputs get from image files with these names.
Names names_from(const Names& files, const Names& drawn = {}) {
  const TemporaryDirectory directory;
  InputChoice choice{{}, {}, drawn};
  for (const std::string& file : files) {
    choice.pictures.push_back(directory.with(file, ""));
    write_grey(choice.pictures.back(), noise_image(9, 9, 50, 1, 1).view());
  }
  Names names;
  for (const TimedInput& input : timed_inputs(choice)) names.push_back(input.name);
  return names;
}

double foreground_share(const ByteImage& image) {
  return static_cast<double>(foreground_pixels(image.view())) /
         static_cast<double>(image.width() * image.height());
}

TEST(TimedInputs, are_the_scene_where_nothing_is_chosen) {
  EXPECT_EQ(names_from({}), (Names{"scene"}));
  EXPECT_EQ(names_from({"scene.png"}, {"square_64", "noise_9_50_1"}),
            (Names{"scene_image", "square_64", "noise_9_50_1"}));
}

TEST(TimedInputs, image_files_are_binarised_as_requested_and_keep_their_grey_levels) {
  const TemporaryDirectory directory;
  ByteImage dot(20, 10);
  for (Index y = 0; y < 10; ++y) std::fill_n(dot.view().row(y), 20, std::uint8_t{30});
  dot.at(7, 5) = 90;
  const std::string file = directory.file("dot.png");
  write_grey(file, dot.view());
  std::ostringstream log;
  const std::vector<TimedInput> chosen = timed_inputs({{file}, {}, {}}, &log);
  EXPECT_EQ(foreground_pixels(chosen.front().binary.view()), 1);
  EXPECT_TRUE(equal(chosen.front().grey.view(), dot.view()));
  EXPECT_EQ(log.str().find("note: " + file + ": foreground is bright"), 0U) << log.str();
  const std::vector<TimedInput> requested = timed_inputs({{file}, {Foreground::dark, 80}, {}});
  EXPECT_EQ(foreground_pixels(requested.front().binary.view()), 199);
}

TEST(DrawnInput, squares_are_tiles_of_the_scene) {
  const Scene scene = render_scene();
  const TimedInput input = drawn_input("square_1023");
  ASSERT_EQ(input.width(), 1023);
  for (Index y = 0; y < 1023; y += 7) {
    for (Index x = 0; x < 1023; ++x) {
      ASSERT_EQ(input.binary.at(x, y), scene.binary.at(x % 510, y % 412));
      ASSERT_EQ(input.grey.at(x, y), scene.grey.at(x % 510, y % 412));
    }
  }
  EXPECT_EQ(drawn_input("tiled_2").height(), 2 * 412);
}

TEST(DrawnInput, enlarged_repeats_every_pixel) {
  const TimedInput input = drawn_input("enlarged_3");
  const TimedInput scene = drawn_input("scene");
  ASSERT_EQ(input.width(), 3 * scene.width());
  EXPECT_EQ(foreground_pixels(input.binary.view()), 9 * foreground_pixels(scene.binary.view()));
}

TEST(DrawnInput, noise_has_the_density_and_the_blocks_of_its_name) {
  const TimedInput input = drawn_input("noise_512_30_4");
  EXPECT_NEAR(foreground_share(input.binary), 0.3, 0.02);
  for (Index x = 0; x < 512; ++x) ASSERT_EQ(input.binary.at(x, 9), input.binary.at(x / 4 * 4, 8));
  EXPECT_EQ(foreground_share(drawn_input("noise_64_0_1").binary), 0);
  EXPECT_EQ(foreground_share(drawn_input("noise_64_100_1").binary), 1);
}

TEST(DrawnInput, squares_are_a_quarter_of_the_image_and_do_not_touch_its_border) {
  for (const char* name : {"squares_512_4", "squares_512_64", "squares_512_256"}) {
    const ByteImage image = std::move(drawn_input(name).binary);
    EXPECT_EQ(foreground_share(image), 0.25) << name;
    EXPECT_EQ(image.at(0, 0) + image.at(511, 511), 0) << name;
  }
}

TEST(DrawnInput, strokes_are_a_stack_of_images) {
  const TimedInput input = drawn_input("strokes_28_5");
  EXPECT_EQ(input.width(), 28);
  EXPECT_EQ(input.height(), 5 * 28);
}

TEST(DrawnInput, rejects_other_names_and_sizes) {
  for (const char* name :
       {"", "oval_9", "square_0", "square_65537", "square_9_9", "tiled_129", "noise_9_101_1",
        "noise_9_50_0", "squares_9_0", "strokes_2000_1", "strokes_28_0", "scene_1"}) {
    EXPECT_EQ(rejection_of<UsageError>([&] {
                static_cast<void>(drawn_input(name));
              }).find("input '" + std::string(name) + "': expected scene, square_N, "),
              0U)
        << name;
  }
}

TEST(SmallCopy, has_few_rows_of_more_than_a_word) {
  const TimedInput scene = drawn_input("scene");
  const TimedInput small = small_copy(scene);
  EXPECT_EQ(small.name, "scene_small");
  EXPECT_EQ(small.width(), 102);
  EXPECT_EQ(small.height(), 26);
  EXPECT_EQ(small.binary.at(101, 25), scene.binary.at(505, 400));
  EXPECT_EQ(small.grey.at(7, 9), scene.grey.at(35, 144));
}

/// Of 8.4 megapixels, as `./study pages` draws them.
TEST(DrawnInput, pages_are_the_same_bytes_on_every_machine) {
  const auto hash = [](const char* name) { return pixel_hash(drawn_input(name).binary.view()); };
  EXPECT_EQ(hash("halftone_2896"), 0x27a0c874f34c89ceU);
  EXPECT_EQ(hash("page_2896"), 0xee6f010a79e16fbdU);
  EXPECT_EQ(hash("noise_2896_5_1"), 0x06361418067ea8b1U);
  EXPECT_EQ(hash("noise_2896_41_1"), 0x981086f8cf6edf10U);
  EXPECT_EQ(hash("noise_2896_50_4"), 0x33cb74b440e3feb5U);
}

TEST(DrawnInput, a_page_is_empty_where_there_is_no_room_for_a_line) {
  EXPECT_EQ(foreground_share(drawn_input("page_40").binary), 0);
  EXPECT_GT(foreground_share(drawn_input("page_200").binary), 0);
}

TEST(StrokeImages, have_as_much_foreground_as_written_digits_and_two_empty_pixels_at_the_border) {
  const ByteImage images = stroke_images(200, 28, 2);
  EXPECT_GT(foreground_share(images), 0.1);
  EXPECT_LT(foreground_share(images), 0.3);
  for (Index i = 0; i < 200; ++i) {
    for (Index along = 0; along < 28; ++along) {
      for (const Index margin : {0, 1, 26, 27}) {
        EXPECT_EQ(images.at(along, i * 28 + margin), 0);
        EXPECT_EQ(images.at(margin, i * 28 + along), 0);
      }
    }
  }
}

}  // namespace
}  // namespace thinbench
