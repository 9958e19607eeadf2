#include "core/planes.hpp"

#include <gtest/gtest.h>

#include "core/layout.hpp"
#include "support/margins.hpp"

namespace thinbench::detail {
namespace {

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

}  // namespace
}  // namespace thinbench::detail
