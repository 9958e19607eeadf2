// Batches of small images: equal to the reference one by one, and what the public edge refuses.
#include "thinbench/batch.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "harness/operation.hpp"
#include "harness/test_images.hpp"
#include "support/splitmix64.hpp"

namespace thinbench {
namespace {

constexpr std::uint8_t kGap = 0x5A;

/// Owns images with gaps between rows and images.
class Stack {
 public:
  Stack(Index count, Index width, Index height, Index row_gap = 0, Index image_gap = 0)
      : view_{nullptr, count,           width,
              height,  width + row_gap, height * (width + row_gap) + image_gap},
        bytes_(static_cast<std::size_t>(count * view_.image_stride), kGap) {}

  [[nodiscard]] StackView view() {
    StackView view = view_;
    view.data = bytes_.data();
    return view;
  }

  void set(Index i, const ConstImageView& image) {
    for (Index y = 0; y < image.height; ++y) {
      std::copy_n(image.row(y), image.width, view().image(i).row(y));
    }
  }

  /// Whether nothing was written between rows and images.
  [[nodiscard]] bool gaps_are_whole() const {
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
      const auto in_image = static_cast<Index>(i) % view_.image_stride;
      const bool pixel =
          in_image < view_.height * view_.stride && in_image % view_.stride < view_.width;
      if (!pixel && bytes_[i] != kGap) return false;
    }
    return true;
  }

 private:
  StackView view_;
  std::vector<std::uint8_t> bytes_;
};

/// Images of all densities and grains.
Stack random_stack(Index count, Index width, Index height, std::uint64_t seed) {
  Stack stack(count, width, height, static_cast<Index>(seed % 4), static_cast<Index>(seed % 3));
  for (Index i = 0; i < count; ++i) {
    const std::uint64_t random = splitmix64(seed, static_cast<std::uint64_t>(i));
    const int percent = static_cast<int>(random % 101);
    const Index grain = 1 + static_cast<Index>(random >> 32) % 5;
    stack.set(i, noise_image(width, height, percent, grain, random).view());
  }
  return stack;
}

struct Expected {
  Stack images;
  int passes;
};

Expected expected_of_stack(std::string_view operation, Stack& source) {
  const StackView view = source.view();
  Expected expected = {Stack(view.count, view.width, view.height), 0};
  for (Index i = 0; i < view.count; ++i) {
    const Outcome one = expected_of(operation, view.image(i));
    expected.images.set(i, one.image.view());
    expected.passes = std::max(expected.passes, static_cast<int>(one.numbers[0]));
  }
  return expected;
}

/// The first image that differs, or -1.
Index first_difference(StackView a, StackView b) {
  for (Index i = 0; i < a.count; ++i) {
    if (!equal(a.image(i), b.image(i))) return i;
  }
  return -1;
}

void expect_batch(std::string_view operation, Stack& source, const Options& options,
                  Expected& expected) {
  const StackView in = source.view();
  Stack out(in.count, in.width, in.height, 3, 5);
  EXPECT_EQ(thin_batch(operation, in, out.view(), options), expected.passes);
  EXPECT_EQ(first_difference(out.view(), expected.images.view()), -1)
      << operation << ' ' << in.count << " images of " << in.width << " x " << in.height << " at "
      << isa_name(options.isa.value_or(best_isa())) << ", threads " << options.threads;
  EXPECT_TRUE(out.gaps_are_whole());
}

void expect_batch_at_every_level(std::string_view operation, Stack& source) {
  Expected expected = expected_of_stack(operation, source);
  for (const Isa isa : kAllIsas) {
    if (!isa_available(isa)) continue;
    for (const int threads : {1, 2, 7}) {
      expect_batch(operation, source, {.isa = isa, .threads = threads}, expected);
    }
  }
}

std::vector<std::string_view> operations_with_lanes() {
  std::vector<std::string_view> names;
  for (const ThinningOperation& operation : thinning_operations()) {
    if (operation.lane_kernels != nullptr) names.push_back(operation.name);
  }
  return names;
}

class BatchOf : public testing::TestWithParam<std::string_view> {};

TEST_P(BatchOf, random_images_of_every_width_equals_the_reference) {
  for (Index width = 1; width <= kMaxLaneWidth + 2; ++width) {
    const std::uint64_t random = splitmix64(17, static_cast<std::uint64_t>(width));
    const Index height = 1 + static_cast<Index>(random % 70);
    const Index count = 1 + static_cast<Index>((random >> 16) % (width <= 64 ? 40 : 12));
    Stack source = random_stack(count, width, height, random);
    expect_batch_at_every_level(GetParam(), source);
  }
}

TEST_P(BatchOf, all_images_of_four_by_four_equals_the_reference) {
  constexpr Index count = 1 << 16;
  Stack source(count, 4, 4);
  for (Index i = 0; i < count; ++i) {
    source.set(i, image_of_bits(4, 4, static_cast<std::uint64_t>(i)).view());
  }
  expect_batch_at_every_level(GetParam(), source);
}

/// Everything dark, the frame, a cross of lines from side to side, and light.
ByteImage shape_at_the_frame(int shape, Index width, Index height) {
  ByteImage image(width, height);
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) {
      const bool frame = x < 3 || y < 3 || x >= width - 3 || y >= height - 3;
      const bool lines = x % 7 == 0 || y % 5 == 0;
      const bool dark[] = {true, frame, lines, false};
      image.at(x, y) = dark[shape] ? 255 : 0;
    }
  }
  return image;
}

TEST_P(BatchOf, shapes_that_touch_the_frame_and_each_other_equals_the_reference) {
  for (const Index width : {1, 2, 16, 28, 32, 33, 64, 65, 100, 128}) {
    for (const Index height : {1, 2, 3, 28}) {
      Stack source(9, width, height);
      for (int i = 0; i < 9; ++i) source.set(i, shape_at_the_frame(i % 4, width, height).view());
      expect_batch_at_every_level(GetParam(), source);
    }
  }
}

TEST_P(BatchOf, images_with_the_border_kept_equals_them_one_by_one) {
  for (const Index width : {1, 2, 3, 28, 32, 64, 65, 128}) {
    for (const Index height : {1, 2, 3, 30}) {
      Stack source = random_stack(19, width, height, static_cast<std::uint64_t>(width));
      Expected expected = {Stack(19, width, height), 0};
      for (Index i = 0; i < 19; ++i) {
        const int passes = thin(GetParam(), source.view().image(i), expected.images.view().image(i),
                                {.border = Border::keep});
        expected.passes = std::max(expected.passes, passes);
      }
      for (const Isa isa : kAllIsas) {
        if (!isa_available(isa)) continue;
        expect_batch(GetParam(), source, {.isa = isa, .border = Border::keep}, expected);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, BatchOf, testing::ValuesIn(operations_with_lanes()),
                         [](const auto& test) { return std::string(test.param); });

TEST(ThinBatch, what_has_no_lanes_is_thinned_one_by_one) {
  Stack source = random_stack(21, 40, 31, 5);
  for (const ThinningOperation& operation : thinning_operations()) {
    const bool lanes = operation.lane_kernels != nullptr;
    EXPECT_EQ(ThinningBatch(operation, 40, 31).one_by_one(), !lanes) << operation.name;
    Expected expected = expected_of_stack(operation.name, source);
    for (const int threads : {1, 3}) {
      expect_batch(operation.name, source, {.threads = threads}, expected);
    }
  }
  EXPECT_FALSE(ThinningBatch("thin_guo_hall", 128, 5).one_by_one());
  EXPECT_TRUE(ThinningBatch("thin_guo_hall", 129, 5).one_by_one());
  EXPECT_TRUE(
      ThinningBatch("thin_guo_hall", 28, 28, {.technique = Technique::bitpacked}).one_by_one());
}

TEST(ThinBatch, any_byte_but_0_is_dark) {
  Stack source(2, 5, 5);
  Stack usual(2, 5, 5);
  for (Index i = 0; i < 2; ++i) {
    ByteImage image = noise_image(5, 5, 80, 1, 3);
    usual.set(i, image.view());
    for (Index x = 0; x < 25; ++x) {
      std::uint8_t& pixel = image.at(x % 5, x / 5);
      pixel = pixel == 0 ? 0 : static_cast<std::uint8_t>(1 + x);
    }
    source.set(i, image.view());
  }
  Expected expected = expected_of_stack("thin_guo_hall", usual);
  expect_batch("thin_guo_hall", source, {}, expected);
}

TEST(ThinBatch, source_and_destination_may_be_one_stack) {
  for (const Index width : {28, 64, 128, 150}) {
    Stack source = random_stack(37, width, 20, 8);
    Expected expected = expected_of_stack("thin_zhang_suen", source);
    EXPECT_EQ(thin_batch("thin_zhang_suen", source.view(), source.view()), expected.passes);
    EXPECT_EQ(first_difference(source.view(), expected.images.view()), -1);
    EXPECT_TRUE(source.gaps_are_whole());
  }
}

TEST(ThinBatch, threads_share_the_images_of_either_way) {
  for (const Index width : {28, 140}) {
    Stack source = random_stack(100, width, 12, 4);
    Expected expected = expected_of_stack("thin_guo_hall", source);
    for (const int threads : {2, 3, 7, 64}) {
      expect_batch("thin_guo_hall", source, {.threads = threads}, expected);
    }
  }
}

TEST(ThinBatch, no_images_take_no_pass_and_images_without_pixels_one) {
  EXPECT_EQ(thin_batch("thin_guo_hall", ConstStackView{}, StackView{}), 0);
  EXPECT_EQ(
      thin_batch("thin_guo_hall", {nullptr, 0, 28, 28, 28, 784}, {nullptr, 0, 28, 28, 28, 784}), 0);
  EXPECT_EQ(thin_batch("thin_guo_hall", {nullptr, 3, 0, 28, 0, 0}, {nullptr, 3, 0, 28, 0, 0}), 1);
  EXPECT_EQ(thin_batch("thin_mb2", {nullptr, 3, 28, 0, 28, 0}, {nullptr, 3, 28, 0, 28, 0}), 1);
}

TEST(ThinBatch, may_be_repeated_with_other_counts) {
  ThinningBatch batch("thin_guo_hall", 28, 28, {.threads = 2});
  for (const Index count : {40, 3, 0, 17}) {
    Stack source = random_stack(count, 28, 28, static_cast<std::uint64_t>(count));
    Expected expected = expected_of_stack("thin_guo_hall", source);
    Stack out(count, 28, 28);
    EXPECT_EQ(batch.run(source.view(), out.view()), expected.passes);
    EXPECT_EQ(first_difference(out.view(), expected.images.view()), -1);
  }
}

std::string refusal_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::string refused_stacks(const ConstStackView& source, const StackView& destination) {
  return refusal_of([&] { thin_batch("thin_guo_hall", source, destination); });
}

TEST(ThinBatch, names_what_is_wrong_with_a_stack) {
  std::vector<std::uint8_t> from(100, kGap);
  std::vector<std::uint8_t> to(100, kGap);
  const StackView good = {to.data(), 4, 5, 5, 5, 25};
  const auto refused = [&](Index count, Index width, Index height, Index stride, Index image) {
    return refused_stacks({from.data(), count, width, height, stride, image}, good);
  };
  EXPECT_EQ(refused(-1, 5, 5, 5, 25),
            "source is -1 images of 5 x 5; counts and sizes cannot be negative");
  EXPECT_EQ(refused(4, 5, -5, 5, 25),
            "source is 4 images of 5 x -5; counts and sizes cannot be negative");
  EXPECT_EQ(refused(4, 5, 5, 4, 25), "source has a stride of 4 bytes, below its width of 5");
  EXPECT_EQ(refused(4, 5, 5, 5, 24), "source has an image stride of 24 bytes; its images take 25");
  EXPECT_EQ(refused(PTRDIFF_MAX / 2, 5, 5, 5, 25),
            "source spans more memory than there is: 4611686018427387903 images of 5 x 5, strides "
            "5 and 25");
  EXPECT_EQ(refused(4, 5, PTRDIFF_MAX / 2, 5, 25),
            "source spans more memory than there is: 4 images of 5 x 4611686018427387903, strides "
            "5 and 25");
  EXPECT_EQ(refused(3, 5, 5, 5, 25),
            "source is 3 images of 5 x 5 and destination 4 images of 5 x 5; they must be alike");
  EXPECT_EQ(refused_stacks({nullptr, 4, 5, 5, 5, 25}, good), "source has no data");
  EXPECT_EQ(refused_stacks({to.data() + 1, 3, 5, 5, 5, 25}, {to.data(), 3, 5, 5, 5, 25}),
            "source and destination overlap without being the same images");
  EXPECT_TRUE(std::all_of(to.begin(), to.end(), [](std::uint8_t byte) { return byte == kGap; }));
}

TEST(ThinBatch, refuses_options_that_do_not_fit) {
  const auto refused = [](std::string_view operation, Index width, const Options& options) {
    return refusal_of([&] { ThinningBatch(operation, width, 5, options); });
  };
  EXPECT_EQ(refused("thin_all", 5, {}), "no operation is named thin_all");
  EXPECT_EQ(refused("thin_guo_hall", 5, {.threads = 0}), "threads is 0; it must be in 1..1024");
  EXPECT_EQ(refused("thin_guo_hall", -5, {}), "image size -5 x 5 is negative");
  EXPECT_EQ(refused("thin_guo_hall", 5, {.directions = Directions{}}),
            "thin_guo_hall takes no directions");
  EXPECT_EQ(refused("thin_spta", 5, {.border = Border::keep}), "thin_spta cannot keep the border");
  EXPECT_NE(refused("thin_guo_hall", 5, {.technique = Technique::simd_runs}), "");
}

TEST(ThinBatch, refuses_images_of_another_size_than_its_own) {
  Stack stack(2, 5, 6);
  ThinningBatch batch("thin_guo_hall", 28, 28);
  EXPECT_EQ(refusal_of([&] { batch.run(stack.view(), stack.view()); }),
            "the batch is for images of 28 x 28, these are 5 x 6");
}

}  // namespace
}  // namespace thinbench
