// Nets with newly trained weights.
#include <gtest/gtest.h>

#include "techniques/given_weights.hpp"
#include "training/two_layer.hpp"

namespace thinbench {
namespace {

TEST(TrainedNets, every_variant_equals_the_reference) {
  for (const std::uint64_t seed : {2U, 3U}) {
    const TrainedTwoLayer trained = train_two_layer(keep_table_of_rule(), {.seed = seed});
    ASSERT_EQ(trained.right_linear, 256);
    expect_every_variant_equals_reference(to_weights(trained.net), Activation::linear);
    expect_every_variant_equals_reference(to_weights(trained.net), Activation::sigmoid);
  }
}

}  // namespace
}  // namespace thinbench
