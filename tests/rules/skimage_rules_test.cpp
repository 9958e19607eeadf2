// What the rules of scikit-image have in common with Zhang and Suen's and Guo and Hall's.
#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "rules/rule_table.hpp"
#include "support/made_image.hpp"

namespace thinbench {
namespace {

template <int sub>
int differing_decisions() {
  const auto skimage = detail::make_rule_table<detail::ZhangSuenSkimage, sub>();
  const auto zhang_suen = detail::make_rule_table<detail::ZhangSuen, sub>();
  int count = 0;
  for (std::size_t k = 0; k < skimage.size(); ++k) count += skimage[k] != zhang_suen[k] ? 1 : 0;
  return count;
}

TEST(ZhangSuenSkimage, differs_from_zhang_suen_in_31_of_512_decisions) {
  EXPECT_EQ(differing_decisions<0>() + differing_decisions<1>(), 31);
}

ByteImage rotated_by_180_degrees(const ByteImage& image) {
  return image_by(image.width(), image.height(), [&](Index x, Index y) {
    return image.at(image.width() - 1 - x, image.height() - 1 - y);
  });
}

TEST(GuoHallSkimage, is_guo_hall_of_the_image_rotated_by_180_degrees) {
  for (const int percent : {40, 70, 95}) {
    const ByteImage image = noise_image(131, 77, percent, 3, static_cast<std::uint64_t>(percent));
    const ByteImage expected =
        rotated_by_180_degrees(thinned(Rule::guo_hall, rotated_by_180_degrees(image)));
    EXPECT_TRUE(equal(thinned(Rule::guo_hall_skimage, image).view(), expected.view()));
    EXPECT_FALSE(equal(thinned(Rule::guo_hall, image).view(), expected.view()));
  }
}

}  // namespace
}  // namespace thinbench
