#include <gtest/gtest.h>

#include "images/regions.hpp"
#include "peers/mat_of.hpp"
#include "support/byte_image.hpp"

namespace thinbench {
namespace {

using Positions = std::vector<std::size_t>;

void fill(ByteImage& image, const cv::Rect& area, std::uint8_t level) {
  mat_of(image.view())(area).setTo(level);
}

/// By first pixels: a dot of 1 pixel; a plate of 20 x 20 with holes of 4 pixels and of 100 with an
/// island of 9 in it; a ring of 8 pixels round a hole of 1.
ByteImage image() {
  ByteImage image(60, 40);
  image.at(50, 0) = 255;
  fill(image, {5, 5, 20, 20}, 255);
  fill(image, {7, 6, 2, 2}, 0);
  fill(image, {10, 10, 10, 10}, 0);
  fill(image, {12, 12, 3, 3}, 255);
  fill(image, {40, 30, 3, 3}, 255);
  image.at(41, 31) = 0;
  return image;
}

struct Sizes {
  std::vector<std::int64_t> objects;
  std::vector<std::int64_t> holes;
  std::vector<std::uint32_t> enclosing_objects;
  bool operator==(const Sizes&) const = default;
};

Sizes sizes_of(const Regions& found) {
  Sizes sizes;
  for (const Region& object : found.objects) sizes.objects.push_back(object.area);
  for (const Region& hole : found.holes) {
    sizes.holes.push_back(hole.area);
    sizes.enclosing_objects.push_back(hole.enclosing_object);
  }
  return sizes;
}

Sizes kept_sizes(std::int64_t min_area) {
  const Regions found = find_regions(image().view());
  return sizes_of(selected(found, kept_regions(found, min_area)));
}

TEST(RegionFilter, area_1_keeps_all_as_they_are) {
  const Regions found = find_regions(image().view());
  const Regions kept = selected(found, kept_regions(found, 1));
  EXPECT_EQ(kept.objects, found.objects);
  EXPECT_EQ(kept.holes, found.holes);
  EXPECT_EQ(sizes_of(found), (Sizes{{1, 296, 9, 8}, {4, 91, 1}, {2, 2, 4}}));
}

TEST(RegionFilter, min_area_is_inclusive_and_enclosing_objects_are_renumbered) {
  EXPECT_EQ(kept_sizes(2), (Sizes{{296, 9, 8}, {4, 91}, {1, 1}}));
  EXPECT_EQ(kept_sizes(4), kept_sizes(2));
  EXPECT_EQ(kept_sizes(5), (Sizes{{296, 9, 8}, {91}, {1}}));
}

TEST(RegionFilter, holes_go_with_their_object_and_objects_stay_without_their_hole) {
  const Regions found = find_regions(image().view());
  EXPECT_EQ(kept_regions(found, 9).objects, (Positions{1, 2})) << "the ring has 8 pixels";
  EXPECT_EQ(kept_sizes(92), (Sizes{{296}, {}, {}}));
  EXPECT_EQ(kept_sizes(297), (Sizes{}));
  Regions thin = found;
  thin.objects[1].area = 1;  // smaller than its hole and than the object inside
  EXPECT_EQ(sizes_of(selected(thin, kept_regions(thin, 9))), (Sizes{{9}, {}, {}}));
}

}  // namespace
}  // namespace thinbench
