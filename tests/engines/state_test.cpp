// Requirements on the states of all variants of all rules, besides the correct result.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "engines/plane_state.hpp"
#include "harness/test_images.hpp"
#include "support/made_image.hpp"
#include "support/margins.hpp"
#include "support/rule_parameters.hpp"
#include "support/variant_of.hpp"
#include "techniques/byte_planes.hpp"

namespace thinbench::detail {
namespace {

constexpr Index kWidth = 133;
constexpr Index kHeight = 41;

/// Whether the margins of the state's planes of T are zero; true if it has none.
template <class T>
bool margins_are_zero(ThinningState& state) {
  const auto* planes = dynamic_cast<PlaneState<T>*>(&state);
  if (planes == nullptr) return true;
  return margin_is_zero(planes->planes.source.view()) &&
         margin_is_zero(planes->planes.result.view());
}

TEST(ThinningState, margins_of_planes_remain_zero) {
  const ByteImage image = noise_image(kWidth, kHeight, 95, 1, 9);
  const ByteImage full = filled_image(kWidth, kHeight, 255);
  ByteImage result(kWidth, kHeight);
  for (const RuleAndBorder& tested : rules_and_borders()) {
    for_each_state(
        thinning_parameters(tested.rule, {.border = tested.border}), kWidth, kHeight, 2,
        [&](ThinningState& state, const std::string& name) {
          state.run(full.view(), result.view());
          state.run(image.view(), result.view());
          EXPECT_TRUE(margins_are_zero<std::uint8_t>(state)) << tested.name << ' ' << name;
          EXPECT_TRUE(margins_are_zero<std::uint64_t>(state)) << tested.name << ' ' << name;
        });
  }
}

TEST(MakeState, rejects_images_wider_than_the_limit_of_the_variant) {
  const ThinningParameters parameters = thinning_parameters(Rule::naccache_shinghal, {});
  const auto variants = variants_of(parameters);
  const auto is_row = [](const auto& variant) { return variant.technique == "simd_bitpacked_row"; };
  if (std::none_of(variants.begin(), variants.end(), is_row)) {
    GTEST_SKIP() << "no row kernel is compiled for this processor";
  }
  for (const ThinningVariant& variant : variants) {
    if (!is_row(variant)) continue;
    EXPECT_EQ(variant.max_width, 512);
    EXPECT_FALSE(unavailable_reason(variant, 513).empty());
    EXPECT_THROW(static_cast<void>(make_state(variant, 513, 5, parameters, 1)),
                 std::invalid_argument);
  }
}

}  // namespace
}  // namespace thinbench::detail
