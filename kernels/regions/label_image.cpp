#include "regions/label_image.hpp"

#include <algorithm>

#include "core/packing.hpp"
#include "core/planes.hpp"

namespace thinbench::detail {
namespace {

class LabelledImage {
 public:
  explicit LabelledImage(const ConstImageView& source) : runs_(source.width, source.height) {
    BitPlane plane(source.width, source.height);
    plane_conversion<std::uint64_t>(best_isa()).read(source, plane.view());
    lists_ = runs_.label_and_number(plane.view());
  }

  [[nodiscard]] const RegionLists& lists() const { return lists_; }

  /// Writes row y, without its first `skipped` pixels, from the labels of holes and of objects.
  template <class OfHole, class OfObject>
  void paint_row(Index y, Index skipped, std::int32_t* row, Index width, const OfHole& of_hole,
                 const OfObject& of_object) {
    const RunRow runs = runs_.row(y);
    for (Index i = 0; i <= runs.count; ++i) {
      const Index begin = i == 0 ? 0 : column_of(runs.keys[i - 1]) - skipped;
      const Index end = i == runs.count ? width : column_of(runs.keys[i]) - skipped;
      const Label root = runs_.roots(static_cast<int>(i % 2))[runs.labels[i]];
      const Index first = std::clamp<Index>(begin, 0, width);
      std::fill_n(row + first, std::clamp<Index>(end, first, width) - first,
                  i % 2 == 0 ? of_hole(root) : of_object(root));
    }
  }

 private:
  LabelledRuns runs_;
  RegionLists lists_;
};

constexpr auto kNoLabel = [](Label) { return std::int32_t{0}; };
constexpr auto kObjectId = [](Label index) { return static_cast<std::int32_t>(index + 1); };

/// The image with foreground and background exchanged, in a frame of foreground one pixel wide.
ByteImage framed_complement(const ConstImageView& source) {
  ByteImage framed(source.width + 2, source.height + 2);
  for (Index y = 0; y < framed.height(); ++y) {
    std::fill_n(framed.view().row(y), framed.width(), std::uint8_t{1});
  }
  for (Index y = 0; y < source.height; ++y) {
    std::transform(source.row(y), source.row(y) + source.width, framed.view().row(y + 1) + 1,
                   [](std::uint8_t pixel) { return static_cast<std::uint8_t>(pixel == 0); });
  }
  return framed;
}

/// A hole in framed_complement() as an object of the image.
Region without_frame(Region region) {
  region.sum_x -= region.area;
  region.sum_y -= region.area;
  for (std::int32_t* side : {&region.left, &region.top, &region.right, &region.bottom}) --*side;
  region.enclosing_object = 0;
  return region;
}

}  // namespace

Regions paint_regions(const ConstImageView& source, const LabelView& labels) {
  LabelledImage image(source);
  const auto objects = static_cast<std::int32_t>(image.lists().objects.size());
  const auto of_hole = [objects](Label hole) {
    return hole == 0 ? 0 : objects + static_cast<std::int32_t>(hole);
  };
  Regions found = {{image.lists().objects.begin(), image.lists().objects.end()},
                   {image.lists().holes.begin(), image.lists().holes.end()}};
  for (Index y = 0; y < labels.height; ++y) {
    image.paint_row(y, 0, labels.row(y), labels.width, of_hole, kObjectId);
  }
  return found;
}

std::vector<Region> paint_eight_connected(const ConstImageView& source, const LabelView& labels) {
  LabelledImage image(source);
  std::vector<Region> objects(image.lists().objects.begin(), image.lists().objects.end());
  for (Index y = 0; y < labels.height; ++y) {
    image.paint_row(y, 0, labels.row(y), labels.width, kNoLabel, kObjectId);
  }
  return objects;
}

/// Holes are 4-connected, so the image's 4-connected objects are the holes of its complement.
std::vector<Region> paint_four_connected(const ConstImageView& source, const LabelView& labels) {
  LabelledImage image(framed_complement(source).view());
  std::vector<Region> objects(image.lists().holes.size());
  std::transform(image.lists().holes.begin(), image.lists().holes.end(), objects.begin(),
                 without_frame);
  const auto hole_id = [](Label hole) { return static_cast<std::int32_t>(hole); };
  for (Index y = 0; y < labels.height; ++y) {
    image.paint_row(y + 1, 1, labels.row(y), labels.width, hole_id, kNoLabel);
  }
  return objects;
}

}  // namespace thinbench::detail
