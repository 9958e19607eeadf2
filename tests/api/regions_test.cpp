// find_regions(), find_components(), fill_holes() and the Euler numbers.
#include "thinbench/regions.hpp"

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "holes.hpp"
#include "support/isa_parameters.hpp"
#include "support/rejection.hpp"
#include "support/text_image.hpp"

namespace thinbench {
namespace {

TEST(FindRegions, equals_the_reference_by_default) {
  for (const Index width : {1, 64, 200, 1100}) {
    const ByteImage image = noise_image(width, 60, 45, 2, 5);
    const reference::Regions expected = reference::holes(image.view());
    for (const int threads : {1, 3}) {
      const Regions found = find_regions(image.view(), {.threads = threads});
      EXPECT_EQ(found.objects, expected.objects) << width;
      EXPECT_EQ(found.holes, expected.holes) << width;
      EXPECT_EQ(find_components(image.view(), {.threads = threads}), expected.objects) << width;
    }
    EXPECT_EQ(euler_number(image.view()), reference::euler_number(image.view()));
    EXPECT_EQ(euler_number_4(image.view()), reference::euler_number_4(image.view()));
  }
}

TEST(FindRegions, finds_nothing_in_images_without_pixels) {
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0}, {0, 5}, {5, 0}}) {
    const ConstImageView image = {nullptr, width, height};
    EXPECT_TRUE(find_regions(image).objects.empty());
    EXPECT_TRUE(find_regions(image, {.threads = 4}).holes.empty());
    EXPECT_TRUE(find_components(image).empty());
    EXPECT_EQ(euler_number(image), 0);
    EXPECT_EQ(euler_number_4(image), 0);
    fill_holes(image, {nullptr, width, height});
  }
}

TEST(EulerNumber, depends_on_the_connectivity) {
  const ByteImage diamond = image_of({".#.", "#.#", ".#."});
  EXPECT_EQ(euler_number(diamond.view()), 0) << "one object around one hole";
  EXPECT_EQ(euler_number_4(diamond.view()), 4) << "four objects, and all background is outside";
}

TEST(FillHoles, fills_holes_and_the_objects_inside_them) {
  const ByteImage image = image_of({"#####..", "#...#.#", "#.#.#..", "#...#..", "#####.."});
  const TextImage expected = {"#####..", "#####.#", "#####..", "#####..", "#####.."};
  ByteImage filled(image.width(), image.height());
  fill_holes(image.view(), filled.view());
  EXPECT_EQ(text_of(filled), expected);
  filled = copy_of(image.view());
  fill_holes(filled.view(), filled.view());
  EXPECT_EQ(text_of(filled), expected) << "in place";
}

TEST(FillHoles, depends_on_the_connectivity_of_objects) {
  const ByteImage image = image_of({".#.....", "#.#.###", ".#..#.#", "....###"});
  ByteImage filled(image.width(), image.height());
  fill_holes(image.view(), filled.view(), Connectivity::four, kAnyHoleArea);
  EXPECT_EQ(text_of(filled), (TextImage{".#.....", "#.#.###", ".#..###", "....###"}));
  fill_holes(image.view(), filled.view(), Connectivity::eight, kAnyHoleArea);
  EXPECT_EQ(text_of(filled), (TextImage{".#.....", "###.###", ".#..###", "....###"}));
}

TEST(FillHoles, fills_holes_up_to_an_area_without_the_objects_inside_them) {
  const ByteImage image = image_of({"#####..", "#...###", "#.#.#.#", "#...###", "#####.."});
  const TextImage small = {"#####..", "#...###", "#.#.###", "#...###", "#####.."};
  const TextImage all = {"#####..", "#######", "#######", "#######", "#####.."};
  ByteImage filled(image.width(), image.height());
  const auto filled_up_to = [&](std::int64_t area) {
    fill_holes(image.view(), filled.view(), Connectivity::eight, area);
    return text_of(filled);
  };
  EXPECT_EQ(filled_up_to(0), text_of(image));
  EXPECT_EQ(filled_up_to(1), small);
  EXPECT_EQ(filled_up_to(7), small);
  EXPECT_EQ(filled_up_to(8), all);
  EXPECT_EQ(filled_up_to(kAnyHoleArea), all);
}

TEST(FillHoles, rejects_a_negative_area_and_an_unknown_connectivity) {
  const ByteImage image = noise_image(10, 4, 50, 1, 2);
  ByteImage out = copy_of(image.view());
  const auto rejected = [&](Connectivity objects, std::int64_t area) {
    return rejection_of([&] { fill_holes(image.view(), out.view(), objects, area); });
  };
  EXPECT_EQ(rejected(Connectivity::four, -1), "max_area: expected at least 0, got -1");
  EXPECT_EQ(rejected(static_cast<Connectivity>(6), 1), "connectivity: expected 4 or 8, got 6");
  EXPECT_TRUE(equal(out.view(), image.view()));
}

/// The error for a view, which must be the same from all operations on one image.
std::string rejected_view(const ConstImageView& view) {
  const std::string text = rejection_of([&] { (void)find_regions(view); });
  EXPECT_EQ(rejection_of([&] { (void)find_components(view); }), text);
  EXPECT_EQ(rejection_of([&] { (void)euler_number(view); }), text);
  EXPECT_EQ(rejection_of([&] { (void)euler_number_4(view); }), text);
  return text;
}

TEST(FindRegions, rejects_invalid_views) {
  const ByteImage image(10, 4);
  const std::uint8_t* data = image.view().data;
  EXPECT_EQ(rejected_view({nullptr, 10, 4, 64}), "source has no data");
  EXPECT_EQ(rejected_view({data, -1, 4, 64}), "source has the size -1 x 4");
  EXPECT_EQ(rejected_view({data, 10, 4, 9}),
            "source has a stride of 9 bytes, below its width of 10");
  const Index side = Index{1} << 29;
  EXPECT_EQ(rejected_view({data, side + 1, 0}),
            "image size 536870913 x 0 has a side above 2^29 pixels");
  EXPECT_EQ(rejected_view({data, 0, side + 1}),
            "image size 0 x 536870913 has a side above 2^29 pixels");
  EXPECT_EQ(rejected_view({data, 1 << 17, 1 << 17}),
            "image size 131072 x 131072 is larger than 2^32 pixels");
}

TEST(FillHoles, rejects_invalid_views_and_partial_overlap) {
  ByteImage image(50, 12);
  const ImageView view = image.view();
  ByteImage other(20, 10);
  const ConstImageView source = {view.data, 20, 10, view.stride};
  const auto rejected = [](const ConstImageView& from, const ImageView& to) {
    return rejection_of([&] { fill_holes(from, to); });
  };
  EXPECT_EQ(rejected({view.data, 20, 10, 19}, other.view()),
            "source has a stride of 19 bytes, below its width of 20");
  EXPECT_EQ(rejected(source, {other.view().data, 20, 10, 19}),
            "destination has a stride of 19 bytes, below its width of 20");
  EXPECT_EQ(rejected(source, {nullptr, 20, 10, 64}), "destination has no data");
  EXPECT_EQ(rejected(source, ByteImage(21, 10).view()),
            "source is 20 x 10 and destination 21 x 10; they must have the same size");
  EXPECT_EQ(rejected(source, {view.row(2) + 3, 20, 10, view.stride}),
            "source and destination overlap without being the same image");
  EXPECT_EQ(rejected(source, {view.data + 25, 20, 10, view.stride}), "") << "side by side";
}

/// find_regions' error; checks that fill_holes fails without writing.
std::string rejected_execution(const Execution& execution) {
  const ByteImage image = noise_image(10, 4, 50, 1, 2);
  ByteImage out = copy_of(image.view());
  const std::string text = rejection_of([&] { (void)find_regions(image.view(), execution); });
  EXPECT_TRUE(is_one_sentence(text)) << text;
  EXPECT_NE(rejection_of([&] { fill_holes(image.view(), out.view(), execution); }), "");
  EXPECT_NE(rejection_of([&] { (void)euler_number(image.view(), execution); }), "");
  EXPECT_TRUE(equal(out.view(), image.view()));
  return text;
}

TEST(FindRegions, rejects_an_unsuitable_execution) {
  EXPECT_EQ(rejected_execution({.threads = 0}), "threads: expected an integer in [1, 1024], got 0");
  EXPECT_EQ(rejected_execution({.isa = static_cast<Isa>(99)}),
            "isa: expected one of " + all_isa_names() + ", got number 99");
}

TEST(EulerNumber, of_one_row_takes_any_stride) {
  const std::array<std::uint8_t, 5> row = {0, 255, 0, 255, 255};
  EXPECT_EQ(euler_number({row.data(), 5, 1, PTRDIFF_MAX}), 2);
}

}  // namespace
}  // namespace thinbench
