// The documented properties of the midpoint scan, on many kinds of images.
#include <bit>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "holes.hpp"
#include "support/made_image.hpp"
#include "support/property_images.hpp"
#include "thinbench/midpoint_scan.hpp"

namespace thinbench {
namespace {

ByteImage scanned(const ByteImage& image, Directions directions = {}) {
  ByteImage marks(image.width(), image.height());
  midpoint_scan(image.view(), marks.view(), directions);
  return marks;
}

Directions only(Direction direction) {
  Directions directions = kNoDirections;
  directions.add(direction);
  return directions;
}

/// Step in x and y along each direction.
constexpr std::pair<Index, Index> kSteps[] = {{1, 0}, {0, 1}, {1, 1}, {-1, 1}};

bool foreground_at(const ByteImage& image, Index x, Index y) {
  return x >= 0 && y >= 0 && x < image.width() && y < image.height() && image.at(x, y) != 0;
}

/// The marks on a run, and whether all of them are at its centre.
struct RunMarks {
  Index count = 0;
  bool central = true;
};

RunMarks marks_of_run(const ByteImage& image, const ByteImage& marks, Index x, Index y,
                      std::pair<Index, Index> step) {
  Index length = 0;
  while (foreground_at(image, x + length * step.first, y + length * step.second)) ++length;
  RunMarks found;
  for (Index i = 0; i < length; ++i) {
    if (!foreground_at(marks, x + i * step.first, y + i * step.second)) continue;
    found.count += 1;
    found.central = found.central && i == (length - 1) / 2;
  }
  return found;
}

TEST(MidpointScanProperties, each_direction_marks_exactly_the_centre_of_each_run) {
  for (const ByteImage& image : property_images()) {
    for (const Direction direction : kAllDirections) {
      const ByteImage marks = scanned(image, only(direction));
      const std::pair<Index, Index> step = kSteps[static_cast<std::size_t>(direction)];
      EXPECT_EQ(pixels_outside(marks, image), 0);
      Index wrong = 0;
      for (Index y = 0; y < image.height(); ++y) {
        for (Index x = 0; x < image.width(); ++x) {
          const bool starts =
              foreground_at(image, x, y) && !foreground_at(image, x - step.first, y - step.second);
          if (!starts) continue;
          const RunMarks found = marks_of_run(image, marks, x, y, step);
          wrong += found.count == 1 && found.central ? 0 : 1;
        }
      }
      EXPECT_EQ(wrong, 0) << "direction " << static_cast<int>(direction);
    }
  }
}

TEST(MidpointScanProperties, all_directions_together_mark_a_subset_with_a_pixel_of_every_object) {
  for (const ByteImage& image : property_images()) {
    const ByteImage marks = scanned(image);
    EXPECT_EQ(pixels_outside(marks, image), 0);
    std::vector<std::int32_t> labels(static_cast<std::size_t>(image.width() * image.height()));
    const LabelView view = {labels.data(), image.width(), image.height()};
    const auto objects = reference::label_objects(image.view(), view);
    std::set<std::int32_t> hit;
    for (Index y = 0; y < image.height(); ++y) {
      for (Index x = 0; x < image.width(); ++x) {
        if (marks.at(x, y) != 0) hit.insert(view.row(y)[x]);
      }
    }
    EXPECT_EQ(hit.size(), objects.size());
  }
}

TEST(MidpointScanProperties, is_idempotent_for_at_most_one_direction) {
  // With one direction every mark is a run of one pixel, because background separates runs. With
  // several directions, marks of different directions touch and form longer runs.
  for (int bits = 0; bits < 1 << kDirectionCount; ++bits) {
    const Directions directions = {static_cast<std::uint8_t>(bits)};
    bool idempotent = true;
    std::vector<ByteImage> images = property_images();
    images.push_back(filled_image(5, 5, 255));
    for (const ByteImage& image : images) {
      const ByteImage marks = scanned(image, directions);
      idempotent = idempotent && equal(scanned(marks, directions).view(), marks.view());
    }
    EXPECT_EQ(idempotent, std::popcount(directions.bits) <= 1) << bits;
  }
}

}  // namespace
}  // namespace thinbench
