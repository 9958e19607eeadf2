#include "experiments/operation_counts.hpp"

#include "training/cluster_training.hpp"

namespace thinbench {
namespace {

template <class Number>
Neighbourhood<Number> dark_pixel_with(int k) {
  const auto n = [k](int i) { return Number(neighbour(k, i)); };
  return {Number(1), n(0), n(1), n(2), n(3), n(4), n(5), n(6), n(7)};
}

/// The four expressions and the number of TRUE ones: what the paper counts.
CountedLane expressions_as_printed(const Neighbourhood<CountedLane>& n) {
  const auto negated = [](CountedLane a) { return a ^ 1; };
  const CountedLane b4 =
      n.n0 & (n.n1 | n.n2 | n.n6 | n.n7) & (n.n2 | negated(n.n3)) & (negated(n.n5) | n.n6);
  const CountedLane b0 =
      n.n4 & (n.n2 | n.n3 | n.n5 | n.n6) & (n.n6 | negated(n.n7)) & (negated(n.n1) | n.n2);
  const CountedLane b2 =
      n.n6 & (n.n0 | n.n4 | n.n5 | n.n7) & (n.n0 | negated(n.n1)) & (negated(n.n3) | n.n4);
  const CountedLane b6 =
      n.n2 & (n.n0 | n.n1 | n.n3 | n.n4) & (n.n4 | negated(n.n5)) & (negated(n.n7) | n.n0);
  return b0 + b2 + b4 + b6;
}

void fill_inputs(int k, CountedFloat (&n)[kNetInputs]) {
  for (int i = 0; i < kNetInputs; ++i) n[i] = CountedFloat(static_cast<float>(neighbour(k, i)));
}

CountedFloat power_of_two(int exponent) {
  ++tally.current().powers;
  return CountedFloat(static_cast<float>(1 << exponent));
}

/// Equations (5), (6) and (7); which net is responsible is looked up in a table, which costs none
/// of the operations counted.
bool cluster_keeps(const ClusterWeights& weights, const CountedFloat (&n)[kNetInputs]) {
  CountedFloat descriptor = n[0] * power_of_two(0);
  for (int i = 1; i < kNetInputs; ++i) descriptor = descriptor + n[i] * power_of_two(i);
  int net = 0;
  while (static_cast<float>(weights.nets[net].last) < descriptor.value()) ++net;
  const Neuron& neuron = weights.nets[net].neuron;
  CountedFloat sum(neuron.bias);
  for (int i = 0; i < kNetInputs; ++i) sum = sum + CountedFloat(neuron.weight[i]) * n[i];
  return sum >= CountedFloat(0.0F);
}

StayTable table_of_cluster(const ClusterWeights& weights) {
  StayTable table{};
  for (int k = 0; k < kDescriptors; ++k) {
    CountedFloat n[kNetInputs];
    fill_inputs(k, n);
    table[static_cast<std::size_t>(k)] = cluster_keeps(weights, n);
  }
  return table;
}

void keep_larger(Operations& most, const Operations& other) {
  most.logical = std::max(most.logical, other.logical);
  most.additions = std::max(most.additions, other.additions);
  most.multiplications = std::max(most.multiplications, other.multiplications);
  most.divisions = std::max(most.divisions, other.divisions);
  most.powers = std::max(most.powers, other.powers);
  most.comparisons = std::max(most.comparisons, other.comparisons);
}

/// Counts `decide(k)` for each descriptor k of a dark pixel.
template <class Decide>
OperationCount count(std::string method, std::string paper, const Decide& decide) {
  OperationCount result = {std::move(method), std::move(paper), {}};
  for (int k = 0; k < kDescriptors; ++k) {
    const Tally counted = count_operations([&] { decide(k); });
    keep_larger(result.most.sums, counted.sums);
    keep_larger(result.most.activations, counted.activations);
  }
  return result;
}

template <int inputs>
Gates count_gates() {
  using Word = CountedWord<inputs>;
  const auto n = [](int variable) { return Word(counting_pattern(variable, 0)); };
  Word::counted = Gates{};
  (void)NaccacheShinghal::next<0>(
      Neighbourhood<Word>{n(8), n(0), n(1), n(2), n(3), n(4), n(5), n(6), n(7)});
  return Word::counted;
}

std::vector<OperationCount> count_methods(const ClusterWeights& cluster) {
  const HiddenLayerNet net = to_net(kPaperTwoLayer);
  const auto net_with = [&net](Activation activation) {
    return [&net, activation](int k) {
      CountedFloat n[kNetInputs];
      fill_inputs(k, n);
      (void)net_keeps(net, n, activation);
    };
  };
  const auto cluster_at = [&cluster](int k) {
    CountedFloat n[kNetInputs];
    fill_inputs(k, n);
    (void)cluster_keeps(cluster, n);
  };
  const auto expressions = [](int k) {
    (void)expressions_as_printed(dark_pixel_with<CountedLane>(k));
  };
  const auto whole_rule = [](int k) {
    (void)NaccacheShinghal::printed<0>(dark_pixel_with<CountedLane>(k));
  };
  constexpr const char* kPaperTwoLayerCount = "more than 150 arithmetic";
  return {
      count("Naccache-Shinghal, four expressions and their sum", "40 logical, 3 arithmetic",
            expressions),
      count("Naccache-Shinghal, decision and update too", "", whole_rule),
      count("Two-layer net, sigmoid", kPaperTwoLayerCount, net_with(Activation::kSigmoid)),
      count("Two-layer net, linear threshold", kPaperTwoLayerCount, net_with(Activation::kLinear)),
      count("Cluster of single-layer nets", "39 arithmetic", cluster_at)};
}

}  // namespace

OperationCounts run_operation_counts() {
  const StayTable rule = stay_table_of_rule();
  const HiddenLayerNet net = to_net(kPaperTwoLayer);
  const ClusterWeights cluster =
      cluster_weights(train_cluster(rule, {kMostClusterNets, /*small_integers=*/true}));
  return {count_methods(cluster),
          {count_gates<2>(), count_gates<3>()},
          {{"Table 1, sigmoid", table_of(net, Activation::kSigmoid) == rule},
           {"Table 1, linear threshold", table_of(net, Activation::kLinear) == rule},
           {"trained cluster", table_of_cluster(cluster) == rule}}};
}

}  // namespace thinbench
