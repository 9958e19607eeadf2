#include <gtest/gtest.h>

#include "training/two_layer.hpp"
#include "training/weights_text.hpp"

namespace thinbench {
namespace {

TrainedTwoLayer train(std::uint64_t seed) {
  return train_two_layer(keep_table_of_rule(), {.seed = seed});
}

TEST(TwoLayerNet, table_1_is_right_on_all_256_descriptors_with_both_activations) {
  const HiddenLayerNet net = to_net(kPaperTwoLayer);
  EXPECT_EQ(table_of(net, Activation::sigmoid), keep_table_of_rule());
  EXPECT_EQ(table_of(net, Activation::linear), keep_table_of_rule());
}

TEST(TwoLayerNet, equation_2_is_linear_up_to_three_and_flat_beyond) {
  EXPECT_EQ(activate(3.0F, Activation::linear), 0.166F * 3 + 0.5F);
  EXPECT_EQ(activate(3.001F, Activation::linear), 1.0F);
  EXPECT_EQ(activate(-3.0F, Activation::linear), 0.166F * -3 + 0.5F);
  EXPECT_EQ(activate(-3.001F, Activation::linear), 0.0F);
}

TEST(TwoLayerTraining, training_reaches_all_256_vectors_with_both_activations) {
  for (const std::uint64_t seed : {2U, 3U, 4U}) {
    const TrainedTwoLayer trained = train(seed);
    EXPECT_EQ(trained.right_sigmoid, 256) << seed;
    EXPECT_EQ(trained.right_linear, 256) << seed;
    EXPECT_EQ(table_of(trained.net, Activation::sigmoid), keep_table_of_rule()) << seed;
  }
}

TEST(TwoLayerTraining, a_seed_gives_the_same_weights_on_every_machine) {
  const TrainedTwoLayer trained = train(2);
  EXPECT_EQ(trained.epochs, 289);
  EXPECT_EQ(trained.restarts, 0);
  const Neuron expected = {{5.08F, 0.25F, 5.34F, 1.78F, -1.66F, -0.9F, -3.19F, 0.43F}, -3.01F};
  for (int i = 0; i < kNetInputs; ++i) {
    EXPECT_EQ(trained.net.hidden[0].weight[i], expected.weight[i]) << i;
  }
  EXPECT_EQ(trained.net.hidden[0].bias, expected.bias);
}

TEST(TwoLayerTraining, effort_is_bounded_and_the_best_net_is_returned) {
  const TrainedTwoLayer trained =
      train_two_layer(keep_table_of_rule(), {.hidden = 2, .max_restarts = 1, .max_epochs = 100});
  EXPECT_EQ(trained.restarts, 1);
  EXPECT_EQ(trained.total_epochs, 200);
  EXPECT_LT(trained.right_sigmoid, 256);
  EXPECT_GE(trained.right_sigmoid, 176);  // as many as "always stays" gets right
  EXPECT_EQ(trained.right_sigmoid,
            agreement(table_of(trained.net, Activation::sigmoid), keep_table_of_rule()));
}

TEST(TwoLayerTraining, nets_of_other_sizes_are_not_written_as_eight_neurons) {
  HiddenLayerNet net = to_net(kPaperTwoLayer);
  net.hidden.pop_back();
  EXPECT_THROW((void)to_weights(net), std::invalid_argument);
}

}  // namespace
}  // namespace thinbench
