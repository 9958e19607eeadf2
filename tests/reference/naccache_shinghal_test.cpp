// The reference on hand-worked examples.
#include <gtest/gtest.h>

#include "support/reference_thinning.hpp"
#include "support/text_image.hpp"

namespace thinbench {
namespace {

Thinned thinned(const TextImage& lines) {
  return thinned_by_reference(Rule::naccache_shinghal, image_of(lines));
}

TEST(ReferenceNaccacheShinghal, thin_lines_and_single_pixels_are_kept) {
  for (const TextImage& image : {TextImage{".....", ".###.", "....."}, {"#"}}) {
    const Thinned result = thinned(image);
    EXPECT_EQ(text_of(result.image), image);
    EXPECT_EQ(result.iterations, 1) << "one iteration that removes nothing";
  }
}

TEST(ReferenceNaccacheShinghal, one_iteration_removes_the_whole_contour) {
  const TextImage bar = {".........", ".#######.", ".#######.", ".#######.", "........."};
  EXPECT_EQ(text_of(thinned(bar).image),
            (TextImage{".........", ".........", "..#####..", ".........", "........."}));
  const TextImage two_rows =
      text_of(thinned({"........", "########", "########", "........"}).image);
  EXPECT_EQ(two_rows[1].substr(2, 4), "....");
  EXPECT_EQ(two_rows[2].substr(2, 4), "....");
}

TEST(ReferenceNaccacheShinghal, shape_on_the_image_border_erodes_from_there) {
  const Thinned result = thinned({"####", "####", "####"});
  EXPECT_EQ(text_of(result.image)[0], "....");
  EXPECT_GT(result.iterations, 1);
}

}  // namespace
}  // namespace thinbench
