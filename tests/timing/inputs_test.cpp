#include "timing/inputs.hpp"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "picture/picture.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

using Names = std::vector<std::string>;

/// The names that inputs get from pictures with these names.
Names names_from(const Names& files, Index largest_square = 0) {
  const TemporaryDirectory folder;
  InputChoice choice{{}, largest_square};
  for (const std::string& file : files) {
    choice.pictures.push_back(folder.file(file));
    std::filesystem::create_directories(
        std::filesystem::path(choice.pictures.back()).parent_path());
    write_grey(choice.pictures.back(), noise_image(9, 9, 50, 1, 1).view());
  }
  Names names;
  for (const TimedInput& input : timed_inputs(choice)) names.push_back(input.name);
  return names;
}

TEST(TimedInputs, are_the_scene_and_squares_where_no_picture_is_given) {
  EXPECT_EQ(names_from({}, 256), (Names{"scene", "square_64", "square_128", "square_256"}));
}

TEST(TimedInputs, pictures_take_the_names_of_their_files_and_each_its_own) {
  EXPECT_EQ(names_from({"horse.png", "a/horse.pgm", "b/horse.png"}),
            (Names{"horse", "horse_2", "horse_3"}));
}

TEST(TimedInputs, pictures_never_take_the_name_of_the_scene_or_of_a_square) {
  EXPECT_EQ(names_from({"scene.png", "square_64.png", "square_9.png", "square_root.png"}, 64),
            (Names{"scene_picture", "square_64_picture", "square_9_picture", "square_root",
                   "square_64"}));
  EXPECT_EQ(names_from({"scene_picture.png", "scene.png"}),
            (Names{"scene_picture", "scene_picture_2"}));
  EXPECT_EQ(names_from({"square.png", "a/square.png", "b/square.png"}, 0),
            (Names{"square", "square_picture", "square_picture_2"}));
}

TEST(TimedInputs, squares_alone_belong_to_the_series_of_sizes) {
  for (const TimedInput& input : timed_inputs({{}, 128})) {
    EXPECT_EQ(input.size_sweep, input.name != "scene") << input.name;
  }
}

/// A bright dot on darker ground.
ByteImage dot() {
  ByteImage image(20, 10);
  for (Index y = 0; y < 10; ++y) std::fill_n(image.view().row(y), 20, std::uint8_t{30});
  image.at(7, 5) = 90;
  return image;
}

TEST(TimedInputs, pictures_are_binarised_as_asked_for_and_keep_their_grey_levels) {
  const TemporaryDirectory folder;
  const std::string file = folder.file("dot.png");
  write_grey(file, dot().view());
  std::ostringstream log;
  const std::vector<TimedInput> chosen = timed_inputs({{file}, 0, {}, &log});
  EXPECT_EQ(foreground_pixels(chosen.front().binary.view()), 1);
  EXPECT_TRUE(equal(chosen.front().grey.view(), dot().view()));
  EXPECT_EQ(log.str().find("note: " + file + ": foreground is bright"), 0U) << log.str();
  const std::vector<TimedInput> asked = timed_inputs({{file}, 0, {Foreground::dark, 80}});
  EXPECT_EQ(foreground_pixels(asked.front().binary.view()), 199);
}

}  // namespace
}  // namespace thinbench
