#include "images/binarise.hpp"

#include <algorithm>
#include <array>
#include <sstream>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "harness/splitmix64.hpp"
#include "harness/test_images.hpp"
#include "images/image_file.hpp"
#include "peers/mat_of.hpp"
#include "scene/scene.hpp"
#include "support/made_image.hpp"
#include "support/own_directory.hpp"

namespace thinbench {
namespace {

ByteImage all_levels() {
  return image_by(256, 1, [](Index x, Index) { return x; });
}

/// A rectangle of level `part` on level `ground`.
ByteImage rectangle(std::uint8_t ground, std::uint8_t part, const cv::Rect& area = {10, 8, 12, 9}) {
  ByteImage image(40, 30);
  mat_of(image.view()).setTo(ground);
  mat_of(image.view())(area).setTo(part);
  return image;
}

BinaryImage binarised(const ByteImage& grey, const BinariseOptions& options = {}) {
  return binarise(copy_of(grey.view()), options);
}

std::string remarks(const ByteImage& grey, const BinariseOptions& options = {}) {
  std::ostringstream log;
  print_remarks("a.png", binarised(grey, options), options, log);
  return log.str();
}

constexpr BinariseOptions bright_from(int threshold) {
  return {Foreground::bright, threshold};
}

constexpr BinariseOptions dark_below(int threshold) {
  return {Foreground::dark, threshold};
}

TEST(Binarise, bright_foreground_is_at_or_above_the_threshold_and_dark_below) {
  for (const int threshold : {0, 60, 255}) {
    const BinaryImage bright = binarised(all_levels(), bright_from(threshold));
    const BinaryImage dark = binarised(all_levels(), dark_below(threshold));
    for (Index x = 0; x < 256; ++x) {
      EXPECT_EQ(bright.image.at(x, 0), x >= threshold ? 255 : 0) << x;
      EXPECT_EQ(dark.image.at(x, 0), x < threshold ? 255 : 0) << x;
    }
    EXPECT_EQ(foreground_pixels(bright.image.view()), 256 - threshold);
    EXPECT_EQ(bright.foreground_share, (256 - threshold) / 256.0);
    EXPECT_EQ(dark.foreground_share, threshold / 256.0);
  }
}

/// Compares the threshold, and the pixels by it, with OpenCV's.
void expect_otsu(const ByteImage& grey) {
  cv::Mat expected;
  const double level = cv::threshold(mat_of(grey.view()), expected, 0, 255, cv::THRESH_OTSU);
  const BinaryImage bright = binarised(grey, {Foreground::bright});
  EXPECT_EQ(bright.threshold, static_cast<int>(level) + 1);
  if (bright.only_level) return;
  EXPECT_EQ(cv::norm(mat_of(bright.image.view()), expected, cv::NORM_INF), 0);
  const ByteImage again = binarised(grey, bright_from(bright.threshold)).image;
  EXPECT_TRUE(equal(again.view(), bright.image.view())) << "with the reported threshold";
}

TEST(Binarise, default_threshold_equals_opencvs_otsu_threshold) {
  expect_otsu(grey_noise_image(90, 40, 0, 255, 1));
  expect_otsu(grey_noise_image(7, 50, 90, 99, 2));
  expect_otsu(render_scene().grey);
  expect_otsu(rectangle(31, 77));
  expect_otsu(all_levels());
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const std::uint64_t levels = 1 + seed % 255;
    const auto width = static_cast<Index>(1 + seed % 23);
    expect_otsu(image_by(width, static_cast<Index>(1 + seed % 17), [&](Index x, Index y) {
      return splitmix64(seed, static_cast<std::uint64_t>(y * width + x)) % levels;
    }));
  }
}

TEST(Binarise, channels_of_a_colour_are_its_samples_their_sum_by_weight_and_how_they_differ) {
  const std::uint8_t colour[] = {200, 100, 53, 77};  // the fourth sample is skipped
  for (const auto& [channel, level] : {std::pair(Channel::grey, 125),
                                       {Channel::red, 200},
                                       {Channel::green, 100},
                                       {Channel::blue, 53},
                                       {Channel::saturation, 187},
                                       {Channel::value, 200}}) {
    ByteImage found(1, 1);
    EXPECT_EQ(select_channel({colour, 1, 1, 4, 4}, found.view(), channel), channel);
    EXPECT_EQ(found.at(0, 0), level) << channel_name(channel);
  }
}

TEST(Binarise, channel_of_a_grey_part_of_a_colour_image_is_grey) {
  const std::uint8_t rows[] = {10, 10, 10, 20, 20, 20, 200, 100, 50};
  ByteImage found(1, 2);
  EXPECT_EQ(select_channel({rows, 1, 2, 3, 3}, found.view(), Channel::red), Channel::grey);
  EXPECT_EQ(found.at(0, 1), 20);
}

TEST(Binarise, default_window_is_an_eighth_of_the_smaller_side_odd_and_at_least_15) {
  for (const auto& [width, height, window] :
       {std::array<Index, 3>{40, 30, 15}, {136, 900, 17}, {900, 400, 51}}) {
    const ByteImage grey(width, height);
    ByteImage found(width, height);
    EXPECT_EQ(binarise(grey.view(), found.view(), {.local = LocalThreshold{}}).window, window);
  }
}

TEST(Binarise, default_offset_is_10_and_of_16_bits_10_of_255_parts_of_the_range) {
  const auto level = [](Index x, Index y) { return 37 * x * y % 101; };
  const ByteImage grey = image_by(20, 20, [&](Index x, Index y) { return level(x, y); });
  std::vector<std::uint16_t> deep(400);
  for (Index i = 0; i < 400; ++i) {  // 600 to 9600, so that the offset is 353
    deep[static_cast<std::size_t>(i)] =
        static_cast<std::uint16_t>(600 + 90 * level(i % 20, i / 20));
  }
  const View<const std::uint16_t> view(deep.data(), 20, 20);
  ByteImage found(20, 20), expected(20, 20);
  binarise(grey.view(), found.view(), {.local = LocalThreshold{}});
  binarise(grey.view(), expected.view(), {.local = LocalThreshold{.offset = 10}});
  EXPECT_TRUE(equal(found.view(), expected.view()));
  binarise16(view, found.view(), {.local = LocalThreshold{}});
  binarise16(view, expected.view(), {.local = LocalThreshold{.offset = 353}});
  EXPECT_TRUE(equal(found.view(), expected.view()));
}

TEST(Binarise, local_foreground_where_no_side_deviates_farther_is_bright) {
  const ByteImage flat = image_by(20, 20, [](Index, Index) { return 77; });
  ByteImage out(20, 20);
  const Binarised found = binarise(flat.view(), out.view(), {.local = LocalThreshold{}});
  EXPECT_EQ(found.foreground, Foreground::bright);
  EXPECT_EQ(found.foreground_share, 0);
}

TEST(Binarise, foreground_of_one_pixel_is_all_or_nothing) {
  const ByteImage pixel = image_by(1, 1, [](Index, Index) { return 200; });
  ByteImage out(1, 1);
  for (const auto& [foreground, share] :
       {std::pair{Foreground::bright, 1.0}, {Foreground::dark, 0.0}}) {
    const Binarisation request{.foreground = foreground, .threshold = 100};
    EXPECT_EQ(binarise(pixel.view(), out.view(), request).foreground_share, share);
  }
}

TEST(Binarise, foreground_of_no_pixel_is_the_one_asked_for) {
  for (const auto& [asked, used] : {std::pair{Foreground::automatic, Foreground::bright},
                                    {Foreground::bright, Foreground::bright},
                                    {Foreground::dark, Foreground::dark}}) {
    EXPECT_EQ(binarise({nullptr, 0, 3}, {nullptr, 0, 3}, {.foreground = asked}).foreground, used);
  }
}

TEST(LikelyForeground, is_the_class_that_the_other_surrounds) {
  const BinaryImage dark = binarised(rectangle(200, 40));
  EXPECT_EQ(dark.foreground, Foreground::dark);
  EXPECT_EQ(foreground_pixels(dark.image.view()), 12 * 9);
  const BinaryImage bright = binarised(rectangle(40, 200));
  EXPECT_EQ(bright.foreground, Foreground::bright);
  EXPECT_EQ(foreground_pixels(bright.image.view()), 12 * 9);
}

TEST(LikelyForeground, may_be_the_larger_class_and_cover_less_than_half_of_the_border) {
  const BinaryImage large = binarised(rectangle(200, 40, {1, 1, 38, 28}));
  EXPECT_EQ(large.foreground, Foreground::dark);
  EXPECT_GT(large.foreground_share, 0.5);
  EXPECT_EQ(binarised(rectangle(200, 40, {0, 0, 30, 20})).foreground, Foreground::dark);
  EXPECT_EQ(binarised(rectangle(200, 40, {0, 0, 40, 25})).foreground, Foreground::bright);
}

TEST(LikelyForeground, is_the_smaller_class_if_each_covers_half_of_the_border) {
  ByteImage halves = rectangle(200, 40, {0, 0, 20, 30});
  EXPECT_EQ(binarised(halves).foreground, Foreground::bright) << "equal classes";
  halves.at(5, 5) = 200;
  EXPECT_EQ(binarised(halves).foreground, Foreground::dark);
  halves.at(25, 5) = halves.at(25, 6) = 40;
  EXPECT_EQ(binarised(halves).foreground, Foreground::bright);
}

TEST(LikelyForeground, counts_each_border_pixel_once_in_images_one_pixel_wide_or_high) {
  ByteImage column(1, 5);  // 3 of 5 pixels are bright
  for (const Index y : {0, 1, 2}) column.at(0, y) = 200;
  EXPECT_EQ(binarised(column).foreground, Foreground::dark);
  ByteImage row(6, 1);  // 2 of 6
  row.at(0, 0) = row.at(2, 0) = 200;
  EXPECT_EQ(binarised(row).foreground, Foreground::bright);
  EXPECT_EQ(binarised(all_levels(), {Foreground::automatic, 100}).foreground, Foreground::dark);
  EXPECT_EQ(binarised(all_levels(), {Foreground::automatic, 200}).foreground, Foreground::bright);
}

TEST(LikelyForeground, is_right_on_the_scenes_grey_and_binary) {
  for (const SceneKind kind : {SceneKind::parts, SceneKind::border_touching}) {
    const Scene scene = render_scene({kind});
    EXPECT_EQ(binarised(scene.grey).foreground, Foreground::dark);
    EXPECT_TRUE(equal(binarised(scene.binary).image.view(), scene.binary.view()));
  }
}

TEST(Remarks, name_the_choices_and_what_overrides_them_and_warn_of_images_of_one_class) {
  const std::string dark = "note: a.png: foreground is dark (grey level < ";
  const std::string bright = "note: a.png: foreground is bright (grey level >= ";
  const std::string most = "warning: a.png: 91.0 % of the image is foreground; --foreground ";
  const std::string same = "warning: a.png: all pixels have the same grey level, ";
  struct Case {
    ByteImage image;
    BinariseOptions options;
    std::string expected;
  };
  const Case cases[] = {
      {rectangle(200, 40), {}, dark + "41); --foreground bright and --threshold N override this\n"},
      {rectangle(40, 200),
       {Foreground::automatic, 90},
       bright + "90); --foreground dark overrides this\n"},
      {rectangle(40, 200), {Foreground::bright}, bright + "41); --threshold N overrides this\n"},
      {rectangle(40, 200), bright_from(90), ""},
      // Binary images need no remark unless their foreground is dark.
      {rectangle(0, 255), {}, ""},
      {rectangle(0, 255), {Foreground::bright}, ""},
      {rectangle(255, 0), {}, dark + "1); --foreground bright overrides this\n"},
      {rectangle(255, 0), {Foreground::dark}, ""},
      {rectangle(200, 40), bright_from(90), most + "dark takes the rest instead\n"},
      {rectangle(40, 200), dark_below(90), most + "bright takes the rest instead\n"},
      {rectangle(200, 40, {0, 0, 20, 30}), bright_from(90), ""},  // exactly half
      {rectangle(77, 77), {}, same + "77: none is foreground\n"},
      {ByteImage(9, 9), {}, same + "0: none is foreground\n"},
      {rectangle(255, 255), {}, same + "255: none is foreground\n"},
      {rectangle(77, 77), bright_from(70), same + "77: all of them are foreground\n"},
  };
  for (const auto& [image, options, expected] : cases) {
    EXPECT_EQ(remarks(image, options), expected);
  }
}

TEST(Remarks, warn_of_classes_that_overlap_unless_the_threshold_is_given) {
  const ByteImage noise = grey_noise_image(300, 200, 0, 255, 3);
  const std::string text = remarks(noise, {Foreground::bright});
  EXPECT_NE(text.find("warning: a.png: the two classes overlap: 10"), std::string::npos) << text;
  EXPECT_NE(text.find("or --threshold N\n"), std::string::npos) << text;
  EXPECT_EQ(remarks(noise, bright_from(200)), "");
  EXPECT_EQ(remarks(render_scene().grey, {Foreground::dark}).find("warning"), std::string::npos);
}

TEST(Separation, is_three_quarters_for_uniform_levels_and_1_for_two_levels) {
  EXPECT_NEAR(binarised(all_levels()).separation, 0.75, 0.001);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_LT(binarised(grey_noise_image(64, 64, 0, 255, seed)).separation, kMinSeparation);
    EXPECT_LT(binarised(grey_noise_image(64, 64, 100, 120, seed)).separation, kMinSeparation);
  }
  EXPECT_EQ(binarised(rectangle(100, 101)).separation, 1);
}

using ReadBinary = OwnDirectory;

TEST_F(ReadBinary, binarises_the_file_and_prints_remarks) {
  write_grey("a.png", rectangle(200, 40).view());
  std::ostringstream log;
  EXPECT_EQ(foreground_pixels(read_binary("a.png", {}, &log).view()), 12 * 9);
  EXPECT_EQ(log.str().find("note: a.png: foreground is dark"), 0U) << log.str();
  EXPECT_EQ(foreground_pixels(read_binary("a.png", bright_from(90)).view()), 40 * 30 - 12 * 9);
}

TEST(ForegroundPixels, ignores_bytes_between_rows) {
  const std::uint8_t bytes[] = {1, 0, 9, 0, 255, 9};
  EXPECT_EQ(foreground_pixels({bytes, 2, 2, 3}), 2);
}

}  // namespace
}  // namespace thinbench
