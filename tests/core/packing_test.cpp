#include "core/packing.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "core/layout.hpp"
#include "core/planes.hpp"
#include "harness/test_images.hpp"
#include "simd/word.hpp"
#include "support/isa_tests.hpp"
#include "support/made_image.hpp"
#include "support/margins.hpp"
#include "techniques/byte_planes.hpp"

namespace thinbench::detail {
namespace {

class PlaneConversion : public IsaTest {};

TEST_P(PlaneConversion, packed_pixel_x_is_bit_x_mod_64_of_word_x_div_64) {
  for (const Index width : {1, 7, 63, 64, 65, 127, 128, 130, 510, 512, 515}) {
    const ByteImage image = noise_image(width, 5, 50, 1, 3);
    BitPlane plane(width, 5);
    plane_conversion<std::uint64_t>(GetParam()).read(image.view(), plane.view());
    for (Index y = 0; y < 5; ++y) {
      for (Index x = 0; x < width; ++x) {
        EXPECT_EQ(plane.view().row(y)[x / 64] >> (x % 64) & 1, image.at(x, y) != 0 ? 1U : 0U);
      }
    }
    EXPECT_TRUE(margin_is_zero(plane.view())) << width;
  }
}

TEST_P(PlaneConversion, any_nonzero_byte_is_foreground) {
  ByteImage image(256, 1);
  for (Index x = 0; x < 256; ++x) image.at(x, 0) = static_cast<std::uint8_t>(x);
  BitPlane bits(256, 1);
  plane_conversion<std::uint64_t>(GetParam()).read(image.view(), bits.view());
  BytePlane bytes(256, 1);
  plane_conversion<std::uint8_t>(GetParam()).read(image.view(), bytes.view());
  for (Index x = 0; x < 256; ++x) {
    EXPECT_EQ(bits.view().row(0)[x / 64] >> (x % 64) & 1, x == 0 ? 0U : 1U);
    EXPECT_EQ(bytes.view().row(0)[x], x == 0 ? 0 : 1);
  }
}

template <class T>
void expect_round_trip(Isa isa, Index width) {
  const ByteImage image = noise_image(width, 4, 40, 1, 8);
  Plane<T> plane(width, 4);
  plane_conversion<T>(isa).read(image.view(), plane.view());
  ByteImage wide = filled_image(width + 9, 4, 7);
  ImageView out = wide.view();
  out.width = width;
  const auto& filled = plane;
  plane_conversion<T>(isa).write(filled.view(), out);
  EXPECT_TRUE(equal(out, image.view())) << width;
  for (Index y = 0; y < 4; ++y) {
    for (Index x = width; x < width + 9; ++x) {
      EXPECT_EQ(wide.at(x, y), 7) << "beside width " << width << " in row " << y;
    }
  }
}

TEST_P(PlaneConversion, round_trip_keeps_the_image_and_writes_nothing_else) {
  for (Index width = 1; width <= 200; ++width) {
    expect_round_trip<std::uint8_t>(GetParam(), width);
    expect_round_trip<std::uint64_t>(GetParam(), width);
  }
}

TEST_P(PlaneConversion, round_trip_keeps_images_larger_than_caches_with_and_without_streaming) {
  for (const Index width : {4096, 4100}) {
    const ByteImage image = noise_image(width, 2100, 50, 8, 4);
    BitPlane plane(width, 2100);
    plane_conversion<std::uint64_t>(GetParam()).read(image.view(), plane.view());
    const auto& filled = plane;
    const auto& conversion = plane_conversion<std::uint64_t>(GetParam());
    for (const auto write : {conversion.write, conversion.write_non_temporal}) {
      ByteImage result(width, 2100);
      write(filled.view(), result.view());
      EXPECT_TRUE(equal(result.view(), image.view())) << width;
    }
  }
}

/// Non-temporal stores need aligned rows.
TEST_P(PlaneConversion, writes_large_images_at_any_address_and_stride) {
  constexpr Index width = 4096, height = 2100;
  const ByteImage image = noise_image(width, height, 50, 8, 4);
  BitPlane plane(width, height);
  plane_conversion<std::uint64_t>(GetParam()).read(image.view(), plane.view());
  const auto& filled = plane;
  const auto& conversion = plane_conversion<std::uint64_t>(GetParam());
  for (const auto write : {conversion.write, conversion.write_non_temporal}) {
    for (const Index gap : {63, 64}) {
      std::vector<std::uint8_t> bytes(std::size_t((width + gap) * height));
      const ImageView result = {bytes.data() + gap % 64 / 3, width, height, width + gap};
      write(filled.view(), result);
      EXPECT_TRUE(equal(result, image.view())) << gap;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Isas, PlaneConversion, testing::ValuesIn(detail::kIsas), isa_test_name);

template <class T>
class Planes : public testing::Test {};
using Elements = testing::Types<std::uint8_t, std::uint64_t>;
TYPED_TEST_SUITE(Planes, Elements);

TYPED_TEST(Planes, rows_start_on_cache_lines_and_strides_are_not_multiples_of_4096_bytes) {
  for (const Index width : {0, 1, 64, 510, 512, 4000, 4032, 32192, 32256, 100000}) {
    Plane<TypeParam> plane(width, 3);
    const auto address = reinterpret_cast<std::uintptr_t>(plane.view().row(1));
    EXPECT_EQ(address % kAlignment, 0U) << width;
    EXPECT_NE(plane.view().stride * static_cast<Index>(sizeof(TypeParam)) % 4096, 0) << width;
  }
}

TYPED_TEST(Planes, margin_check_detects_a_nonzero_element_anywhere_in_the_margin) {
  Plane<TypeParam> plane(70, 4);
  const auto view = plane.view();
  EXPECT_TRUE(margin_is_zero(plane.view()));
  view.row(2)[0] = 1;
  EXPECT_TRUE(margin_is_zero(plane.view())) << "a pixel is not margin";
  for (TypeParam* outside :
       {view.row(-2), view.row(-1), view.row(4), view.row(5) + view.row_elements - 1,
        view.row(0) - 1, view.row(3) + view.row_elements, view.row(1) + view.row_elements - 1}) {
    *outside = TypeParam{1};
    EXPECT_FALSE(margin_is_zero(plane.view()));
    *outside = 0;
  }
}

TEST(BitPlane, margin_check_detects_bits_past_the_width_in_the_last_word) {
  BitPlane plane(70, 1);
  plane.view().row(0)[1] = std::uint64_t{1} << 5;
  EXPECT_TRUE(margin_is_zero(plane.view()));
  plane.view().row(0)[1] = std::uint64_t{1} << 6;
  EXPECT_FALSE(margin_is_zero(plane.view()));
}

TEST(ByteImage, equality_ignores_strides) {
  ByteImage a(5, 2);
  ByteImage wide(90, 2);
  ImageView b = wide.view();
  b.width = 5;
  EXPECT_TRUE(equal(a.view(), b));
  b.row(1)[4] = 1;
  EXPECT_FALSE(equal(a.view(), b));
}

// Not inside the test: Clang 14 crashes on a lambda passed to a consteval function there.
constexpr int kFirst = truth_table([](auto a, auto, auto) { return a; });
constexpr int kSecond = truth_table([](auto, auto b, auto) { return b; });
constexpr int kThird = truth_table([](auto, auto, auto c) { return c; });
constexpr int kOdd = truth_table([](auto a, auto b, auto c) { return a ^ b ^ c; });

TEST(Word, truth_table_has_the_encoding_of_vpternlog) {
  EXPECT_EQ(kFirst, 0xF0);
  EXPECT_EQ(kSecond, 0xCC);
  EXPECT_EQ(kThird, 0xAA);
  EXPECT_EQ(kOdd, 0x96);
}

TEST(Word, neighbours_of_packed_pixels_cross_word_boundaries) {
  const std::uint64_t words[3] = {std::uint64_t{1} << 63, 0, 1};
  using Traits = WordTraits<std::uint64_t>;
  EXPECT_EQ(Traits::west(words[1], &words[1]), 1U);
  EXPECT_EQ(Traits::east(words[1], &words[1]), std::uint64_t{1} << 63);
}

}  // namespace
}  // namespace thinbench::detail
