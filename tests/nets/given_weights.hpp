// Compares every variant of a two-layer net with the reference, given the same weights.
#pragma once

#include <gtest/gtest.h>

#include "api/catalogue.hpp"
#include "harness/families.hpp"
#include "harness/test_images.hpp"
#include "harness/verify.hpp"
#include "reference.hpp"
#include "techniques/net_model.hpp"

namespace thinbench {

inline Rule rule_with(Activation activation) {
  return activation == Activation::linear ? Rule::net_two_layer_linear
                                          : Rule::net_two_layer_sigmoid;
}

inline Outcome reference_outcome(const TwoLayerWeights& weights, Activation activation,
                                 Border border, const ConstImageView& image) {
  Outcome outcome{ByteImage(image.width, image.height), {}};
  outcome.numbers = {
      reference::net_two_layer(weights, activation, {border}, image, outcome.image.view())};
  return outcome;
}

/// Compares every available variant with the reference.
inline void expect_every_variant_equals_reference(const TwoLayerWeights& weights,
                                                  Activation activation) {
  const detail::ThinningOperation& operation = detail::operation_of(rule_with(activation));
  const auto net = two_layer_net(weights, activation);
  const ByteImage image = noise_image(130, 50, 90, 1, 4);
  for (const Border border : {Border::background, Border::keep}) {
    const Outcome expected = reference_outcome(weights, activation, border, image.view());
    for (const detail::ThinningVariant& variant : operation.variants) {
      if (!unavailable_reason(variant, 130, border).empty()) continue;
      const bool is_fixed_point = variant.technique == Technique::simd_fixed_point;
      if (is_fixed_point && !net->fixed_point_is_exact) continue;
      const Options options = {.border = border, .threads = 2, .net = net};
      const auto job = thinning_job(make_state(operation, variant, 130, 50, options));
      EXPECT_EQ(find_mismatch(*job, image.view(), expected).value_or(""), "")
          << technique_name(variant.technique) << " at " << isa_name(variant.isa) << ", border "
          << border_name(border);
    }
  }
}

}  // namespace thinbench
