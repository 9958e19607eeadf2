#include <cmath>

#include <gtest/gtest.h>

#include "training/cluster.hpp"
#include "training/portable_math.hpp"

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

}  // namespace
}  // namespace thinbench
