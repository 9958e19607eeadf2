// fill_holes_of_labels().
#include <algorithm>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "holes.hpp"
#include "support/label_image.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

TextImage filled(const TextImage& lines, Connectivity connectivity = Connectivity::eight,
                 std::int64_t max_area = kAnyHoleArea) {
  LabelImage image = labels_of(lines);
  fill_holes_of_labels(image.view(), image.view(), {connectivity, max_area});
  TextImage result;
  for (Index y = 0; y < image.height; ++y) {
    std::string line;
    for (Index x = 0; x < image.width; ++x) {
      const int label = image.view().row(y)[x];
      line += label == 0 ? '.' : static_cast<char>('0' + label);
    }
    result.push_back(line);
  }
  return result;
}

/// Outlines of rectangles, drawn over each other, with some pixels removed.
LabelImage random_rings(std::mt19937& random) {
  const auto below = [&](Index end) {
    return static_cast<Index>(random() % static_cast<unsigned>(end));
  };
  LabelImage image = {20 + below(60), 20 + below(20), {}};
  image.labels.resize(static_cast<std::size_t>(image.width * image.height));
  for (int i = 0; i < 14; ++i) {
    const Index left = below(image.width), top = below(image.height);
    const Index right = left + below(image.width - left), bottom = top + below(image.height - top);
    const auto label = static_cast<std::int32_t>(1 + below(4));
    for (Index y = top; y <= bottom; ++y) {
      for (Index x = left; x <= right; ++x) {
        const bool is_outline = x == left || x == right || y == top || y == bottom;
        if (is_outline) image.view().row(y)[x] = label;
      }
    }
  }
  for (int i = 0; i < 3; ++i) image.view().row(below(image.height))[below(image.width)] = 0;
  return image;
}

void expect_as_reference(const LabelImage& image, Connectivity connectivity,
                         std::int64_t max_area) {
  LabelImage expected = image;
  reference::fill_label_holes(image.view(), expected.view(), connectivity == Connectivity::four,
                              max_area);
  LabelImage found = image;
  fill_holes_of_labels(image.view(), found.view(), {connectivity, max_area});
  EXPECT_EQ(found.labels, expected.labels);
  found = image;
  fill_holes_of_labels(found.view(), found.view(), {connectivity, max_area});
  EXPECT_EQ(found.labels, expected.labels) << "in place";
}

TEST(FillHolesOfLabels, equals_the_reference) {
  std::mt19937 random(34);
  for (int i = 0; i < 300; ++i) {
    const LabelImage image = i % 2 == 0 ? random_labels(random) : random_rings(random);
    for (const Connectivity connectivity : {Connectivity::eight, Connectivity::four}) {
      for (const std::int64_t area :
           {kAnyHoleArea, std::int64_t{0}, std::int64_t{2}, std::int64_t{30}}) {
        expect_as_reference(image, connectivity, area);
      }
    }
  }
}

TEST(FillHolesOfLabels, of_images_worked_by_hand_are_those_of_the_innermost_label_around_them) {
  const std::pair<TextImage, TextImage> images[] = {
      {{"111222", "1.12.2", "111222"}, {"111222", "111222", "111222"}},
      {{"1122", "1..2", "1122"}, {"1122", "1..2", "1122"}},
      {{"333333", "3....3", "3.12.3", "31..23", "3.12.3", "3....3", "333333"},
       {"333333", "333333", "331233", "313323", "331233", "333333", "333333"}},
      {{"1111111", "1.....1", "1.222.1", "1.2.2.1", "1.222.1", "1.....1", "1111111"},
       {"1111111", "1111111", "1122211", "1122211", "1122211", "1111111", "1111111"}},
      {{"22222", "21112", "21.12", "21112", "22222"},
       {"22222", "21112", "21112", "21112", "22222"}},
      {{"1111", "1231", "1.31", "1111"}, {"1111", "1231", "1131", "1111"}}};
  for (const auto& [image, expected] : images) EXPECT_EQ(filled(image), expected);
}

TEST(FillHolesOfLabels, depends_on_the_connectivity_of_labels) {
  const TextImage diamond = {".1.", "1.1", ".1."};
  EXPECT_EQ(filled(diamond), (TextImage{".1.", "111", ".1."}));
  EXPECT_EQ(filled(diamond, Connectivity::four), diamond);
}

TEST(FillHolesOfLabels, fills_holes_up_to_an_area_of_background) {
  const TextImage image = {"1111111", "1.2.1.1", "1111111"};
  EXPECT_EQ(filled(image, Connectivity::eight, 1), (TextImage{"1111111", "1.2.111", "1111111"}))
      << "a hole that another label cuts in two has two pixels";
  EXPECT_EQ(filled(image, Connectivity::eight, 2), (TextImage{"1111111", "1121111", "1111111"}));
  EXPECT_EQ(filled(image, Connectivity::eight, 0), image);
}

TEST(FillHolesOfLabels, takes_strides_and_images_without_pixels) {
  const LabelImage image = labels_of({"1111", "1.1.", "1111"});
  std::vector<std::int32_t> out(15, -7);
  fill_holes_of_labels({image.labels.data(), 3, 3, 4}, {out.data(), 3, 3, 5});
  EXPECT_EQ(out[6], 1);
  EXPECT_EQ(std::count(out.begin(), out.end(), -7), 6);
  fill_holes_of_labels({nullptr, 5, 0}, {nullptr, 5, 0});
  fill_holes_of_labels({nullptr, 0, 5}, {nullptr, 0, 5});
}

}  // namespace
}  // namespace thinbench
