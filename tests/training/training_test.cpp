// Training of nets and what it relies on: separation, and arithmetic that is the same everywhere.
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "support/temporary_directory.hpp"
#include "training/cluster.hpp"
#include "training/portable_math.hpp"
#include "training/two_layer.hpp"
#include "training/weights_text.hpp"

namespace thinbench {
namespace {

constexpr DescriptorRun kSquare = {0, 3};  // all values of n0 and n1

KeepTable exclusive_or() {
  KeepTable table{};
  table[1] = table[2] = true;
  return table;
}

KeepTable random_table(std::uint64_t seed) {
  Random random(seed);
  KeepTable table{};
  for (bool& entry : table) entry = (random.next() & 1) != 0;
  return table;
}

TEST(Separation, exclusive_or_is_contradicted_by_the_two_diagonals) {
  const Contradiction found = find_contradiction(exclusive_or(), kSquare);
  ASSERT_EQ(found.size(), 4U);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(found[static_cast<std::size_t>(k)].descriptor, k);
    EXPECT_EQ(found[static_cast<std::size_t>(k)].times, 1);
  }
  EXPECT_TRUE(shows_inseparable(found, exclusive_or(), kSquare));
}

TEST(Separation, altered_contradictions_prove_nothing) {
  const KeepTable table = exclusive_or();
  EXPECT_FALSE(shows_inseparable({}, table, kSquare));
  EXPECT_FALSE(shows_inseparable({{0, 1}, {1, 1}, {2, 1}, {3, 2}}, table, kSquare));
  EXPECT_FALSE(shows_inseparable({{0, 1}, {1, 1}, {2, 1}}, table, kSquare));
  EXPECT_FALSE(shows_inseparable({{0, -1}, {1, -1}, {2, -1}, {3, -1}}, table, kSquare));
  EXPECT_FALSE(shows_inseparable({{0, 1}, {1, 1}, {2, 1}, {3, 1}}, table, {0, 2}));
}

TEST(Separation, majority_of_eight_neighbours_is_separable) {
  KeepTable table{};
  for (unsigned k = 0; k < kDescriptors; ++k) table[k] = __builtin_popcount(k) >= 4;
  EXPECT_TRUE(find_contradiction(table, {0, 255}).empty());
}

TEST(Separation, runs_of_random_tables_have_either_a_neuron_or_a_contradiction) {
  int separable = 0;
  int contradicted = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const KeepTable table = random_table(seed);
    const int first = static_cast<int>(seed * 2);
    const DescriptorRun run = {first, first + 3 + static_cast<int>(seed % 20)};
    const Contradiction found = find_contradiction(table, run);
    if (found.empty()) {
      EXPECT_TRUE(recognises(train_perceptron(table, run).neuron, table, run)) << seed;
      ++separable;
    } else {
      EXPECT_TRUE(shows_inseparable(found, table, run)) << seed;
      ++contradicted;
    }
  }
  EXPECT_GT(separable, 20);
  EXPECT_GT(contradicted, 20);
}

TEST(Perceptron, gives_up_on_a_run_that_no_neuron_can_learn) {
  EXPECT_THROW((void)train_perceptron(exclusive_or(), kSquare), std::runtime_error);
}

TEST(Perceptron, shrinking_keeps_the_answers_and_never_grows) {
  const KeepTable table = keep_table_of_rule();
  const DescriptorRun run = {213, 224};
  const IntegerNeuron taught = train_perceptron(table, run).neuron;
  const IntegerNeuron small = shrink(taught, table, run);
  const auto magnitude = [](const IntegerNeuron& neuron) {
    int sum = std::abs(neuron.bias);
    for (const int weight : neuron.weight) sum += std::abs(weight);
    return sum;
  };
  EXPECT_TRUE(recognises(small, table, run));
  EXPECT_LT(magnitude(small), magnitude(taught));
}

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

const std::vector<TrainedRun>& trained(bool small_integers) {
  static const std::vector<TrainedRun> plain = train_cluster(keep_table_of_rule(), {});
  static const std::vector<TrainedRun> small =
      train_cluster(keep_table_of_rule(), {kMaxClusterNets, true});
  return small_integers ? small : plain;
}

TEST(ClusterTraining, greedy_cut_gives_exactly_the_twelve_runs) {
  // Found by linear programming in floating point, before this code.
  const std::vector<std::pair<int, int>> expected = {
      {0, 67},    {68, 84},   {85, 89},   {90, 96},   {97, 116},  {117, 121},
      {122, 132}, {133, 207}, {208, 212}, {213, 224}, {225, 244}, {245, 255}};
  std::vector<std::pair<int, int>> found;
  for (const TrainedRun& run : trained(false)) found.emplace_back(run.run.first, run.run.last);
  EXPECT_EQ(found, expected);
}

TEST(ClusterTraining, every_run_is_learned_and_one_more_descriptor_is_impossible) {
  const KeepTable rule = keep_table_of_rule();
  for (const TrainedRun& run : trained(false)) {
    const auto [first, last] = run.run;
    EXPECT_TRUE(recognises(run.neuron, rule, run.run)) << first;
    if (last == kDescriptors - 1) continue;
    EXPECT_TRUE(shows_inseparable(run.one_more, rule, {first, last + 1})) << first;
  }
}

TEST(ClusterTraining, weights_decide_as_the_rule) {
  for (const bool small_integers : {false, true}) {
    const Rule net = Rule::from_net(cluster_weights(trained(small_integers)));
    const Rule rule = Rule::naccache_shinghal;
    EXPECT_EQ(net.sub_iterations().front(), rule.sub_iterations().front());
  }
}

TEST(ClusterTraining, the_committed_header_is_what_training_makes) {
  const std::string committed = bytes_of(THINBENCH_SOURCE_DIR "/kernels/rules/trained_cluster.hpp");
  const std::string made = cluster_header(
      cluster_weights(trained(true)),
      "thinbench-study train cluster --integer --header kernels/rules/trained_cluster.hpp");
  EXPECT_EQ(made, committed);
}

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
