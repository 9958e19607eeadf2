// Every variant of regions, label images and filling on shapes that are awkward for runs as bits
// and for strips of rows, and label images that are written past the caches.
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "harness/families.hpp"
#include "harness/test_images.hpp"
#include "harness/verify.hpp"
#include "regions/state.hpp"
#include "support/made_image.hpp"

namespace thinbench {
namespace {

/// One object: a line that winds to the centre, with one pixel between its turns.
ByteImage spiral(Index side) {
  ByteImage image(side, side);
  Index x = -1, y = 0, dx = 1, dy = 0;
  for (Index length = side, turns = 0; length > 0; ++turns) {
    for (Index i = 0; i < length; ++i) image.at(x += dx, y += dy) = 255;
    if (turns == 0) {
      length = side - 1;
    } else if (turns % 2 == 0) {
      length -= 2;
    }
    const Index west = dy;
    dy = dx;
    dx = -west;
  }
  return image;
}

std::vector<ByteImage> shapes(Index width, Index height) {
  std::vector<ByteImage> images;
  const auto add = [&](const auto& is_foreground) {
    images.push_back(
        image_by(width, height, [&](Index x, Index y) { return is_foreground(x, y) ? 255 : 0; }));
  };
  add([](Index x, Index y) { return (x + y) % 2 == 0; });
  add([](Index x, Index y) { return (x + y / 2) % 2 == 0; });
  add([](Index x, Index y) { return (x + y) % 3 != 0; });
  add([&](Index x, Index y) { return x % 2 == 0 || y == height - 1; });  // combs: teeth up, down
  add([&](Index x, Index y) { return x % 2 == 0 || y == 0; });
  add([&](Index x, Index y) { return x % 4 == 0 || y == (x % 8 == 0 ? 0 : height - 1); });
  add([&](Index x, Index y) { return y % 2 == 0 || x == width - 1; });
  add([&](Index x, Index y) { return y % 4 == 0 || x == (y % 8 < 4 ? 0 : width - 1); });
  add([](Index x, Index y) { return x / 64 % 2 == y / 2 % 2; });
  add([](Index x, Index y) { return (x + 1) % 64 > 1 || y % 3 == 0; });
  add([](Index x, Index y) { return (x * x + y * y) / 40 % 2 == 0; });
  add([](Index, Index) { return true; });
  add([](Index, Index) { return false; });
  return images;
}

std::vector<ByteImage> noise(Index width, Index height) {
  std::vector<ByteImage> images;
  std::uint64_t seed = static_cast<std::uint64_t>(width * 1000 + height);
  for (const int percent : {3, 20, 35, 41, 50, 59, 75, 95}) {
    images.push_back(noise_image(width, height, percent, 1, ++seed));
    images.push_back(noise_image(width, height, percent, 3, ++seed));
  }
  return images;
}

class RunVariants : public ::testing::TestWithParam<std::string> {
 protected:
  void expect_exact(const std::vector<ByteImage>& images) {
    const Operation& operation = operation_of(GetParam());
    for (const ByteImage& image : images) {
      const Outcome expected = expected_of(GetParam(), image.view());
      for (const Variant& variant : operation.variants) {
        if (!variant.unavailable_reason(image.width()).empty()) continue;
        for (const int threads : {1, 2, 7}) {
          if ((threads > 1) != variant.threaded) continue;
          const auto job = variant.make_job(image.width(), image.height(), threads);
          const auto mismatch = find_mismatch(*job, image.view(), expected);
          ASSERT_FALSE(mismatch) << variant.technique << ' ' << isa_name(variant.isa) << ", "
                                 << threads << " threads, " << image.width() << " x "
                                 << image.height() << ": " << *mismatch;
        }
      }
    }
  }
};

TEST_P(RunVariants, are_exact_around_the_width_of_words_and_registers) {
  for (const Index width : {1, 2, 3, 31, 63, 64, 65, 127, 128, 129, 193, 511, 512, 513, 577}) {
    for (const Index height : {1, 2, 3, 6, 13}) {
      expect_exact(shapes(width, height));
      expect_exact(noise(width, height));
    }
  }
}

TEST_P(RunVariants, are_exact_on_spirals_and_their_complements) {
  for (const Index side : {1, 2, 3, 5, 31, 64, 65, 130}) {
    const ByteImage line = spiral(side);
    std::vector<ByteImage> images;
    images.push_back(copy_of(line.view()));
    images.push_back(mapped(line, [](int pixel) { return pixel != 0 ? 0 : 255; }));
    images.push_back(image_by(side, side, [&](Index x, Index y) { return line.at(y, x); }));
    expect_exact(images);
  }
}

TEST_P(RunVariants, are_exact_where_narrow_sums_and_coordinates_would_overflow) {
  for (const auto& [width, height] :
       {std::pair<Index, Index>{20000, 60}, {65534, 5}, {70000, 4}, {9, 3000}}) {
    std::vector<ByteImage> frame_with_a_bar;
    frame_with_a_bar.push_back(image_by(width, height, [w = width, h = height](Index x, Index y) {
      return x == 0 || y == 0 || x == w - 1 || y == h - 1 || x == w / 2 ? 255 : 0;
    }));
    expect_exact(frame_with_a_bar);
  }
}

TEST_P(RunVariants, are_exact_with_more_regions_than_16_bits_number) {
  std::vector<ByteImage> images;
  for (const int shown : {0, 255}) {  // objects, or holes of one object
    images.push_back(image_by(701, 523, [&](Index x, Index y) {
      return x % 2 == 1 && y % 2 == 1 ? 255 - shown : shown;
    }));
  }
  expect_exact(images);
}

INSTANTIATE_TEST_SUITE_P(, RunVariants,
                         ::testing::Values("holes", "components", "label_image", "label_image_4",
                                           "label_components", "label_components_4",
                                           "label_regions", "fill_holes", "fill_holes_4"),
                         [](const auto& param) { return param.param; });

/// Large enough for non-temporal stores, whose lines are joined across rows.
TEST(LabelStates, write_the_same_at_every_stride_and_address_and_nothing_beside) {
  constexpr Index width = 1101, height = 1003;
  constexpr std::int32_t kUnwritten = -9;
  const ByteImage image = noise_image(width, height, 45, 5, 3);
  std::vector<std::int32_t> expected(std::size_t{width * height});
  const LabelView tight(expected.data(), width, height);
  Regions lists;
  for (const detail::LabelOperation& operation : detail::label_operations()) {
    const detail::LabelParameters parameters = {operation.key};
    detail::make_state(operation.variants.front(), width, height, parameters, 1)
        ->run(image.view(), tight, lists);
    for (const auto& variant : operation.variants) {
      if (!unavailable_reason(variant, width).empty()) continue;
      const auto state = detail::make_state(variant, width, height, parameters, 1);
      for (const Index extra : {0, 1, 3, 16, 25}) {
        const auto stride = width + extra;
        std::vector<std::int32_t> found(std::size_t(stride * height + 32), kUnwritten);
        const LabelView view(found.data() + 16 - extra % 16, width, height, stride);
        state->run(image.view(), view, lists);
        std::size_t written = 0;
        for (const std::int32_t label : found) written += label != kUnwritten ? 1 : 0;
        ASSERT_EQ(written, expected.size()) << operation.name << ' ' << isa_name(variant.isa);
        for (Index y = 0; y < height; ++y) {
          ASSERT_TRUE(std::equal(tight.row(y), tight.row(y) + width, view.row(y)))
              << operation.name << ' ' << isa_name(variant.isa) << " row " << y << " + " << extra;
        }
      }
    }
  }
}

}  // namespace
}  // namespace thinbench
