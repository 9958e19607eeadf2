// Operations of each method, counted by running the references' equations on counting types.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "experiments/counting.hpp"
#include "experiments/experiments.hpp"
#include "rules/parallel_rules.hpp"
#include "training/cluster.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::ordered_json;

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

void raise(Operations& max, const Operations& other) {
  max.logical = std::max(max.logical, other.logical);
  max.additions = std::max(max.additions, other.additions);
  max.multiplications = std::max(max.multiplications, other.multiplications);
  max.divisions = std::max(max.divisions, other.divisions);
  max.powers = std::max(max.powers, other.powers);
  max.comparisons = std::max(max.comparisons, other.comparisons);
}

Json operations_json(const Operations& operations) {
  return {{"logical", operations.logical},
          {"additions", operations.additions},
          {"multiplications", operations.multiplications},
          {"divisions", operations.divisions},
          {"powers", operations.powers},
          {"comparisons", operations.comparisons},
          {"arithmetic", operations.arithmetic()}};
}

/// Counts `decide(k)` for each descriptor k of a foreground pixel. `paper` is what section 4 says.
template <class Decide>
Json count(const char* method, const char* paper, const Decide& decide) {
  Tally max;
  for (int k = 0; k < kDescriptors; ++k) {
    const Tally counted = count_operations([&] { decide(k); });
    raise(max.sums, counted.sums);
    raise(max.activations, counted.activations);
  }
  return {{"method", method},
          {"paper", paper},
          {"sums", operations_json(max.sums)},
          {"activations", operations_json(max.activations)}};
}

/// Inverters are counted apart: most instruction sets have and-not, and three-input gates take them
/// in.
template <std::size_t count>
Json count_gates(const detail::Circuit<count>& circuit) {
  const auto has_inverter = [](const detail::Gate& gate) {
    return gate.function == detail::kAndNot;
  };
  return {{"gates", count},
          {"inverters", std::count_if(circuit.gates.begin(), circuit.gates.end(), has_inverter)}};
}

Json count_methods(const ClusterWeights& cluster) {
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
  return Json::array({count("Naccache-Shinghal, four expressions and their sum",
                            "40 logical, 3 arithmetic", expressions),
                      count("Naccache-Shinghal, decision too", "", rule),
                      count("Two-layer net, sigmoid", kPaperTwoLayerCount, sigmoid),
                      count("Two-layer net, linear threshold", kPaperTwoLayerCount, linear),
                      count("Cluster of single-layer nets", "39 arithmetic", of_cluster)});
}

}  // namespace

ExperimentReport operation_counts() {
  const KeepTable rule = keep_table_of_rule();
  const ClusterWeights cluster =
      cluster_weights(train_cluster(rule, {kMaxClusterNets, /*small_integers=*/true}));
  const auto net = [&](const char* name, const auto& keeps) {
    return Json{{"net", name}, {"compiles_to_the_rule", table_by(keeps) == rule}};
  };
  const auto of_cluster = [&](const auto& n) { return reference::cluster_keeps(cluster, n); };
  return report_of(
      "operation-counts",
      "Operations per foreground pixel, counted by running each method, at most over the 256 "
      "neighbourhoods; and whether a net has the rule's table and so compiles to its circuit:",
      {{"per", "foreground pixel; each kind's largest count over the 256 neighbourhoods"},
       {"methods", count_methods(cluster)},
       {"circuit",
        {{"two_input", count_gates(detail::kTwoInputCircuit<BuiltInRule::naccache_shinghal, 0>)},
         {"three_input",
          count_gates(detail::kThreeInputCircuit<BuiltInRule::naccache_shinghal, 0>)}}},
       {"nets",
        {net("Table 1, sigmoid", two_layer<Activation::sigmoid>),
         net("Table 1, linear threshold", two_layer<Activation::linear>),
         net("trained cluster", of_cluster)}}});
}

}  // namespace thinbench
