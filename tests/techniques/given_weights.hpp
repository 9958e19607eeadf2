// Compares every variant of a two-layer net with the reference, given the same weights.
#pragma once

#include <gtest/gtest.h>

#include "harness/families.hpp"
#include "harness/test_images.hpp"
#include "harness/verify.hpp"
#include "reference.hpp"
#include "support/variant_of.hpp"
#include "techniques/net_model.hpp"

namespace thinbench {

inline Outcome reference_outcome(const TwoLayerWeights& weights, Activation activation,
                                 Border border, const ConstImageView& image) {
  Outcome outcome{ByteImage(image.width, image.height), {}};
  outcome.numbers = {
      reference::net_two_layer(weights, activation, {border}, image, outcome.image.view())};
  return outcome;
}

/// Compares every available variant with the reference; without simd_fixed_point where no 8-bit
/// weights are exact.
inline void expect_every_variant_equals_reference(const TwoLayerWeights& weights,
                                                  Activation activation) {
  const Rule rule(weights, activation);
  const bool is_exact = detail::make_net_model(weights, activation, rule.sub_iterations().front())
                            .fixed_point_is_exact;
  const ByteImage image = noise_image(130, 50, 90, 1, 4);
  for (const Border border : {Border::background, Border::keep}) {
    const Outcome expected = reference_outcome(weights, activation, border, image.view());
    const detail::ThinningParameters parameters = detail::thinning_parameters(rule, {border});
    for (const detail::ThinningVariant& variant : variants_of(parameters)) {
      if (!unavailable_reason(variant, 130).empty()) continue;
      if (variant.technique == "simd_fixed_point" && !is_exact) continue;
      const auto job = thinning_job(make_state(variant, 130, 50, parameters, 2));
      EXPECT_EQ(find_mismatch(*job, image.view(), expected).value_or(""), "")
          << name_of(variant) << ", border " << border_name(border);
    }
  }
}

}  // namespace thinbench
