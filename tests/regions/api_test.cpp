// The public edge: what is refused, and what a plan keeps.
#include <stdexcept>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "regions/pictures.hpp"

namespace thinbench {
namespace {

TEST(FindHoles, refuses_bad_views_and_wishes) {
  const ByteImage image(10, 4);
  ConstImageView view = image.view();
  EXPECT_THROW((void)find_regions({nullptr, 10, 4, 64}), std::invalid_argument);
  EXPECT_THROW((void)find_regions({view.data, -1, 4, 64}), std::invalid_argument);
  EXPECT_THROW((void)find_regions({view.data, 10, 4, 9}), std::invalid_argument);
  EXPECT_THROW((void)find_regions(view, {Technique::lut}), std::invalid_argument);
  EXPECT_THROW((void)find_regions(view, {{}, {}, 0}), std::invalid_argument);
  EXPECT_THROW((void)find_components(view, {Technique::lut}), std::invalid_argument);
  EXPECT_THROW((void)euler_number_4({view.data, 10, 4, 9}), std::invalid_argument);
}

TEST(FillHoles, refuses_bad_views_and_partial_overlap) {
  ByteImage image(50, 12);
  const ImageView view = image.view();
  ByteImage other(20, 10);
  const ConstImageView source = {view.data, 20, 10, view.stride};
  EXPECT_THROW(fill_holes({view.data, 20, 10, 19}, other.view()), std::invalid_argument);
  EXPECT_THROW(fill_holes(source, {other.view().data, 20, 10, 19}), std::invalid_argument);
  EXPECT_THROW(fill_holes(source, {nullptr, 20, 10, 64}), std::invalid_argument);
  EXPECT_THROW(fill_holes(source, ByteImage(21, 10).view()), std::invalid_argument);
  EXPECT_THROW(fill_holes(source, {view.row(2) + 3, 20, 10, view.stride}), std::invalid_argument);
  EXPECT_THROW(fill_holes(source, other.view(), {{}, {}, 2}), std::invalid_argument);
  EXPECT_NO_THROW(fill_holes(source, {view.data + 25, 20, 10, view.stride})) << "side by side";
}

TEST(FindComponents, gives_the_objects_of_find_holes) {
  const ByteImage image = noise_image(200, 100, 45, 2, 5);
  EXPECT_EQ(find_components(image.view()), find_regions(image.view()).objects);
  EXPECT_EQ(find_components(image.view(), {{}, {}, 3}), find_regions(image.view()).objects);
}

TEST(EulerNumber, depends_on_which_side_touches_at_corners) {
  const ByteImage diamond = holes_test::picture({".#.", "#.#", ".#."});
  EXPECT_EQ(euler_number(diamond.view()), 0) << "one object round one hole";
  EXPECT_EQ(euler_number_4(diamond.view()), 4) << "four objects, and all light is outside";
}

TEST(FindHoles, has_nothing_to_say_of_images_without_pixels) {
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0}, {0, 5}, {5, 0}}) {
    const ByteImage image(width, height);
    EXPECT_TRUE(find_regions(image.view()).objects.empty());
    EXPECT_TRUE(find_regions(image.view(), {{}, {}, 4}).holes.empty());
    EXPECT_EQ(euler_number(image.view()), 0);
  }
}

TEST(HolesPlan, refuses_sizes_beyond_its_numbers) {
  const HolesOperation& operation = *find_holes_operation("holes");
  const HolesVariant& variant = operation.variants.front();
  EXPECT_THROW(HolesPlan(operation, variant, kMaxHolesSide + 1, 1), std::invalid_argument);
  EXPECT_THROW(HolesPlan(operation, variant, 1 << 17, 1 << 17), std::invalid_argument);
  EXPECT_THROW(HolesPlan(operation, variant, -1, 1), std::invalid_argument);
  EXPECT_THROW(HolesPlan(operation, variant, 1, 1, 1025), std::invalid_argument);
}

TEST(HolesPlan, gives_the_same_after_an_image_with_many_more_regions) {
  const ByteImage simple = noise_image(300, 200, 50, 20, 3);
  const ByteImage crowded = noise_image(300, 200, 50, 1, 4);
  const reference::Regions expected = reference::holes(simple.view());
  const HolesOperation& operation = *find_holes_operation("holes");
  for (const HolesVariant& variant : operation.variants) {
    if (!unavailable_reason(facts_of(variant), 300).empty()) continue;
    HolesPlan plan(operation, variant, 300, 200, variant.threaded ? 4 : 1);
    for (const ByteImage* image : {&simple, &crowded, &simple}) plan.run(image->view());
    const RegionLists found = plan.regions();
    EXPECT_TRUE(std::equal(found.holes.begin(), found.holes.end(), expected.holes.begin(),
                           expected.holes.end()));
    EXPECT_TRUE(std::equal(found.objects.begin(), found.objects.end(), expected.objects.begin(),
                           expected.objects.end()));
  }
}

TEST(HolesPlan, gives_only_what_its_operation_is_asked_for) {
  const auto plan_of = [](std::string_view name, Technique technique) {
    const HolesOperation& operation = *find_holes_operation(name);
    return HolesPlan(operation, choose_variant(operation, 9, {technique}), 9, 9);
  };
  ByteImage image(9, 9);
  for (const Technique technique : {Technique::union_find, Technique::bitpacked_runs}) {
    EXPECT_THROW((void)plan_of("holes", technique).number(), std::logic_error);
    EXPECT_THROW(plan_of("components", technique).store(image.view()), std::logic_error);
    EXPECT_THROW((void)plan_of("fill_holes", technique).regions(), std::logic_error);
  }
  EXPECT_THROW((void)plan_of("euler_number", Technique::lut).regions(), std::logic_error);
}

}  // namespace
}  // namespace thinbench
