// What border and limit mean, on the references of all rules: claims that hold whatever a rule is.
#include <algorithm>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "reference.hpp"
#include "support/text_image.hpp"

namespace thinbench {
namespace {

struct Thinned {
  ByteImage image;
  int iterations;
};

Thinned thinned(Rule rule, const reference::Repetition& repetition, const ByteImage& image) {
  Thinned result = {ByteImage(image.width(), image.height()), 0};
  result.iterations = reference::thinning(rule)(repetition, image.view(), result.image.view());
  return result;
}

/// Shapes on all sides and noise, and sizes that are nothing but border.
std::vector<ByteImage> images() {
  std::vector<ByteImage> all;
  std::uint64_t seed = 40;
  for (const auto& [width, height] :
       {std::pair<Index, Index>{1, 1}, {1, 9}, {9, 1}, {2, 2}, {2, 7}, {3, 3}, {5, 4}, {31, 23}}) {
    for (const int percent : {55, 92, 100}) {
      all.push_back(noise_image(width, height, percent, 1, ++seed));
    }
  }
  return all;
}

bool is_outermost(const ByteImage& image, Index x, Index y) {
  return x == 0 || y == 0 || x == image.width() - 1 || y == image.height() - 1;
}

class Repetition : public testing::TestWithParam<Rule> {};

TEST_P(Repetition, keeps_the_outermost_pixels_where_asked_to) {
  for (const ByteImage& image : images()) {
    for (const int limit : {1, 2, kUnlimited}) {
      const Thinned result = thinned(GetParam(), {Border::keep, limit}, image);
      for (Index y = 0; y < image.height(); ++y) {
        for (Index x = 0; x < image.width(); ++x) {
          if (!is_outermost(image, x, y)) continue;
          ASSERT_EQ(result.image.at(x, y), image.at(x, y)) << x << ", " << y;
        }
      }
    }
  }
}

TEST_P(Repetition, of_images_that_are_all_border_changes_nothing_where_it_is_kept) {
  for (const ByteImage& image : images()) {
    if (image.width() > 2 && image.height() > 2) continue;
    const Thinned result = thinned(GetParam(), {Border::keep}, image);
    EXPECT_TRUE(equal(result.image.view(), image.view()));
    EXPECT_EQ(result.iterations, 1);
  }
}

TEST_P(Repetition, one_iteration_again_and_again_is_all_of_them) {
  if (GetParam() == Rule::midpoint_scan) GTEST_SKIP() << "has one iteration";
  for (const Border border : {Border::background, Border::keep}) {
    for (const ByteImage& image : images()) {
      const Thinned all = thinned(GetParam(), {border}, image);
      ByteImage step = copy_of(image.view());
      for (int done = 1; done <= all.iterations; ++done) {
        const Thinned next = thinned(GetParam(), {border, 1}, step);
        EXPECT_EQ(next.iterations, 1);
        EXPECT_EQ(equal(next.image.view(), step.view()), done == all.iterations)
            << "the last iteration changes nothing, every other does";
        step = copy_of(next.image.view());
        const Thinned limited = thinned(GetParam(), {border, done}, image);
        EXPECT_EQ(limited.iterations, done);
        EXPECT_TRUE(equal(limited.image.view(), step.view()));
      }
      EXPECT_TRUE(equal(step.view(), all.image.view()));
    }
  }
}

TEST_P(Repetition, source_and_destination_may_be_one_image) {
  for (const ByteImage& image : images()) {
    for (const Border border : {Border::background, Border::keep}) {
      const Thinned expected = thinned(GetParam(), {border}, image);
      ByteImage in_place = copy_of(image.view());
      EXPECT_EQ(reference::thinning(GetParam())({border}, in_place.view(), in_place.view()),
                expected.iterations);
      EXPECT_TRUE(equal(in_place.view(), expected.image.view()));
    }
  }
}

std::vector<Rule> all_rules() {
  std::vector<Rule> rules;
  for (const RuleInfo& info : kRules) rules.push_back(info.rule);
  return rules;
}

INSTANTIATE_TEST_SUITE_P(Rules, Repetition, testing::ValuesIn(all_rules()),
                         [](const auto& tested) { return std::string(rule_name(tested.param)); });

TEST(ReferenceZhangSuen, takes_the_second_row_of_a_bar_from_under_the_border_that_is_kept) {
  // By hand: each inner pixel has five foreground neighbours in one run and none below, so the
  // first sub-iteration removes all of them.
  ByteImage image = image_of({"#######", "#######", "......."});
  EXPECT_EQ(reference::thinning(Rule::zhang_suen)({Border::keep}, image.view(), image.view()), 2);
  EXPECT_EQ(text_of(image), (TextImage{"#######", "#.....#", "......."}));
}

}  // namespace
}  // namespace thinbench
