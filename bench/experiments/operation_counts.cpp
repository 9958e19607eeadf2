#include "experiments/operation_counts.hpp"

#include "training/cluster_training.hpp"

namespace thinbench {
namespace {

/// The neighbours of descriptor k as the references take them.
template <class Number>
struct Neighbours {
  explicit Neighbours(int k)
      : n{at(k, 0), at(k, 1), at(k, 2), at(k, 3), at(k, 4), at(k, 5), at(k, 6), at(k, 7)} {}

  Number n[kNetInputs];

 private:
  static Number at(int k, int i) { return Number(neighbour(k, i) != 0); }
};

/// What a decision makes of each descriptor.
template <class Keeps>
KeepTable table_by(const Keeps& keeps) {
  KeepTable table{};
  for (int k = 0; k < kDescriptors; ++k) {
    table[static_cast<std::size_t>(k)] = keeps(Neighbours<float>(k).n);
  }
  return table;
}

/// The decisions of the nets, on numbers that count or do not.
template <Activation activation>
constexpr auto two_layer =
    [](const auto& n) { return reference::two_layer_keeps<activation>(kPaperTwoLayer, n); };

void keep_larger(Operations& most, const Operations& other) {
  most.logical = std::max(most.logical, other.logical);
  most.additions = std::max(most.additions, other.additions);
  most.multiplications = std::max(most.multiplications, other.multiplications);
  most.divisions = std::max(most.divisions, other.divisions);
  most.powers = std::max(most.powers, other.powers);
  most.comparisons = std::max(most.comparisons, other.comparisons);
}

/// Counts `decide(k)` for each descriptor k of a foreground pixel.
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
  const auto n = [](int variable) { return Word(detail::counting_pattern(variable, 0)); };
  Word::counted = Gates{};
  (void)detail::NaccacheShinghal::next<0>(
      detail::Neighbourhood<Word>{n(8), n(0), n(1), n(2), n(3), n(4), n(5), n(6), n(7)});
  return Word::counted;
}

std::vector<OperationCount> count_methods(const ClusterWeights& cluster) {
  using Truths = Neighbours<CountedTruth>;
  using Numbers = Neighbours<CountedFloat>;
  const auto expressions = [](int k) {
    return reference::false_count<CountedFloat>(reference::expressions_of(Truths(k).n));
  };
  const auto rule = [&](int k) { (void)reference::keeps_with(expressions(k)); };
  const auto sigmoid = [](int k) { (void)two_layer<Activation::sigmoid>(Numbers(k).n); };
  const auto linear = [](int k) { (void)two_layer<Activation::linear>(Numbers(k).n); };
  const auto of_cluster = [&cluster](int k) {
    (void)reference::cluster_keeps(cluster, Numbers(k).n);
  };
  constexpr const char* kPaperTwoLayerCount = "more than 150 arithmetic";
  return {count("Naccache-Shinghal, four expressions and their sum", "40 logical, 3 arithmetic",
                expressions),
          count("Naccache-Shinghal, decision too", "", rule),
          count("Two-layer net, sigmoid", kPaperTwoLayerCount, sigmoid),
          count("Two-layer net, linear threshold", kPaperTwoLayerCount, linear),
          count("Cluster of single-layer nets", "39 arithmetic", of_cluster)};
}

}  // namespace

OperationCounts run_operation_counts() {
  const KeepTable rule = keep_table_of_rule();
  const ClusterWeights cluster =
      cluster_weights(train_cluster(rule, {kMaxClusterNets, /*small_integers=*/true}));
  const auto of_cluster = [&](const auto& n) { return reference::cluster_keeps(cluster, n); };
  return {count_methods(cluster),
          {count_gates<2>(), count_gates<3>()},
          {{"Table 1, sigmoid", table_by(two_layer<Activation::sigmoid>) == rule},
           {"Table 1, linear threshold", table_by(two_layer<Activation::linear>) == rule},
           {"trained cluster", table_by(of_cluster) == rule}}};
}

}  // namespace thinbench
