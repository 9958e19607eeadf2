// What the midpoint scan claims of itself, on images of many kinds.
#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/flood_fill.hpp"
#include "thinbench/thinning.hpp"
#include "support/property_images.hpp"

namespace thinbench {
namespace {


ByteImage scanned(const ByteImage& image, Directions directions = {}) {
  ByteImage result(image.width(), image.height());
  thin(Rule::midpoint_scan, image.view(), result.view(), {.directions = directions});
  return result;
}

Directions only(Direction direction) {
  Directions directions = kNoDirections;
  directions.add(direction);
  return directions;
}

/// Column steps and row steps of a direction.
constexpr std::pair<Index, Index> kSteps[] = {{1, 0}, {0, 1}, {1, 1}, {-1, 1}};

bool foreground_at(const ByteImage& image, Index x, Index y) {
  return x >= 0 && y >= 0 && x < image.width() && y < image.height() && image.at(x, y) != 0;
}

/// Marks on the run that starts at (x, y), and whether all of them are at its centre.
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

TEST(MidpointScanProperties, each_direction_marks_one_pixel_of_a_run_and_that_its_centre) {
  for (const ByteImage& image : property_images()) {
    for (const Direction direction : kAllDirections) {
      const ByteImage marks = scanned(image, only(direction));
      const std::pair<Index, Index> step = kSteps[static_cast<std::size_t>(direction)];
      EXPECT_EQ(marked_outside(marks, image), 0);
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

TEST(MidpointScanProperties, all_directions_give_a_subset_with_a_pixel_of_every_object) {
  for (const ByteImage& image : property_images()) {
    const ByteImage marks = scanned(image);
    EXPECT_EQ(marked_outside(marks, image), 0);
    const auto objects = flood_fill::objects_of(image.view());
    std::vector<bool> hit(objects.list.size() + 1);
    for (Index y = 0; y < image.height(); ++y) {
      for (Index x = 0; x < image.width(); ++x) {
        const auto place = static_cast<std::size_t>(y * image.width() + x);
        if (marks.at(x, y) != 0) hit[static_cast<std::size_t>(objects.label[place])] = true;
      }
    }
    EXPECT_EQ(std::count(hit.begin() + 1, hit.end(), true),
              static_cast<std::ptrdiff_t>(objects.list.size()));
  }
}

TEST(MidpointScanProperties, one_direction_is_idempotent_and_so_is_no_larger_set) {
  // In one direction the marks are runs of their own, of one pixel each: two runs have
  // background between them. In two, marks of one touch those of the other and make new runs.
  ByteImage square(5, 5);
  for (Index y = 0; y < 5; ++y) {
    for (Index x = 0; x < 5; ++x) square.at(x, y) = 255;
  }
  for (int bits = 0; bits < 1 << kDirectionCount; ++bits) {
    const Directions directions = {static_cast<std::uint8_t>(bits)};
    bool idempotent = true;
    std::vector<ByteImage> images = property_images();
    images.push_back(copy_of(square.view()));
    for (const ByteImage& image : images) {
      const ByteImage marks = scanned(image, directions);
      idempotent = idempotent && equal(scanned(marks, directions).view(), marks.view());
    }
    EXPECT_EQ(idempotent, std::popcount(directions.bits) <= 1) << bits;
  }
}

}  // namespace
}  // namespace thinbench
