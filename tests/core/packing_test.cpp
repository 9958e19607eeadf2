#include "core/packing.hpp"

#include <gtest/gtest.h>

#include "core/planes.hpp"
#include "harness/test_images.hpp"
#include "support/filled_image.hpp"
#include "support/isa_parameters.hpp"
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

INSTANTIATE_TEST_SUITE_P(Isas, PlaneConversion, testing::ValuesIn(detail::kIsas), isa_test_name);

}  // namespace
}  // namespace thinbench::detail
