#include "training/portable_math.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace thinbench {
namespace {

TEST(PortableMath, exponential_is_within_1e_15_of_the_library) {
  for (int i = -7000; i <= 7000; ++i) {
    const double x = i * 0.1;
    EXPECT_NEAR(portable_exp(x) / std::exp(x), 1.0, 1e-15) << x;
  }
}

TEST(PortableMath, exponential_stays_finite_and_positive_for_any_argument) {
  for (const double x : {-1e300, -701.0, 701.0, 1e300}) {
    EXPECT_TRUE(std::isnormal(portable_exp(x))) << x;
    EXPECT_GT(portable_exp(x), 0.0) << x;
  }
  EXPECT_EQ(portable_exp(0.0), 1.0);
}

TEST(PortableMath, random_numbers_are_those_of_splitmix64) {
  Random random(1234567);  // values published with the generator
  EXPECT_EQ(random.next(), 6457827717110365317U);
  EXPECT_EQ(random.next(), 3203168211198807973U);
}

}  // namespace
}  // namespace thinbench
