// Experiments with the nets: fixed point, the cluster, hidden neurons.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/experiments.hpp"
#include "training/cluster.hpp"
#include "training/two_layer.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMaxBits = 8;

float quantised(float value, Quantisation way, int bits) {
  const float scaled = std::ldexp(value, bits);
  return std::ldexp(way == Quantisation::round ? std::round(scaled) : std::trunc(scaled), -bits);
}

/// Calls `visit` with each weight and bias.
template <class Net, class Visit>
void for_each_number(Net& net, const Visit& visit) {
  for (auto& neuron : net.hidden) {
    for (auto& weight : neuron.weight) visit(weight);
    visit(neuron.bias);
  }
  for (auto& weight : net.output_weight) visit(weight);
  visit(net.output_bias);
}

/// Descriptors of 256 on which the net is right, with both activations.
Json right_descriptors(const HiddenLayerNet& net) {
  const KeepTable rule = keep_table_of_rule();
  return {{"right_sigmoid", agreement(table_of(net, Activation::sigmoid), rule)},
          {"right_linear", agreement(table_of(net, Activation::linear), rule)}};
}

Json quantisation_row(Quantisation way, int bits) {
  const HiddenLayerNet net = quantised(to_net(kPaperTwoLayer), way, bits);
  float largest = 0;
  for_each_number(net, [&](float value) { largest = std::max(largest, std::abs(value)); });
  Json row = {{"weights", way == Quantisation::round ? "rounded" : "truncated"},
              {"fractional_bits", bits}};
  row.update(right_descriptors(net));
  row["largest_integer"] = static_cast<int>(std::ldexp(largest, bits));
  return row;
}

int largest_weight(const IntegerNeuron& neuron) {
  int largest = std::abs(neuron.bias);
  for (const std::int32_t weight : neuron.weight) largest = std::max(largest, std::abs(weight));
  return largest;
}

double median(std::vector<int> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 != 0 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

Json hidden_neurons_row(int hidden, const HiddenNeuronsChoice& choice) {
  std::vector<int> right;
  std::vector<int> epochs;  // of starts that learned everything
  for (int seed = 1; seed <= choice.seeds; ++seed) {
    const TrainedTwoLayer trained =
        train_two_layer(keep_table_of_rule(), {.seed = static_cast<std::uint64_t>(seed),
                                               .hidden = hidden,
                                               .max_restarts = 0,
                                               .max_epochs = choice.max_epochs,
                                               .also_linear = false});
    right.push_back(trained.right_sigmoid);
    if (trained.right_sigmoid == kDescriptors) epochs.push_back(trained.epochs);
  }
  return {{"hidden", hidden},
          {"best", *std::max_element(right.begin(), right.end())},
          {"median", median(right)},
          {"seeds_with_all_right", epochs.size()},
          {"median_epochs_of_those", median(epochs)}};
}

/// 0 if no number did.
Json min_hidden_that_reached_all(const Json& rows) {
  const auto found = std::find_if(
      rows.begin(), rows.end(), [](const Json& row) { return row.at("seeds_with_all_right") > 0; });
  return found == rows.end() ? Json(0) : found->at("hidden");
}

}  // namespace

HiddenLayerNet quantised(const HiddenLayerNet& net, Quantisation way, int bits) {
  HiddenLayerNet result = net;
  for_each_number(result, [&](float& value) { value = quantised(value, way, bits); });
  return result;
}

ExperimentReport quantisation() {
  Json data = {{"descriptors", kDescriptors},
               {"as_published", right_descriptors(to_net(kPaperTwoLayer))},
               {"rows", Json::array()}};
  for (const Quantisation way : {Quantisation::round, Quantisation::truncate}) {
    for (int bits = 0; bits <= kMaxBits; ++bits)
      data["rows"].push_back(quantisation_row(way, bits));
  }
  return report_of(
      "quantisation",
      "Descriptors of 256 on which the net of Table 1 is correct, its weights in fixed point:",
      data);
}

ExperimentReport cluster_runs() {
  const std::vector<TrainedRun> runs =
      train_cluster(keep_table_of_rule(), {kMaxClusterNets, /*small_integers=*/true});
  Json data = {{"descriptors", kDescriptors}, {"nets", runs.size()}, {"rows", Json::array()}};
  for (const TrainedRun& trained : runs) {
    data["rows"].push_back({{"first", trained.run.first},
                            {"last", trained.run.last},
                            {"epochs", trained.epochs},
                            {"largest_weight", largest_weight(trained.neuron)}});
  }
  return report_of("cluster-runs",
                   fmt::format("The longest runs of descriptors that one neuron each can learn: "
                               "{} nets, and no division has fewer.",
                               runs.size()),
                   data);
}

ExperimentReport hidden_neurons(const HiddenNeuronsChoice& choice,
                                const std::function<void(double)>& progress) {
  Json rows = Json::array();
  for (int hidden = choice.min_hidden; hidden <= choice.max_hidden; ++hidden) {
    progress(static_cast<double>(rows.size()) / (choice.max_hidden - choice.min_hidden + 1));
    rows.push_back(hidden_neurons_row(hidden, choice));
  }
  return report_of(
      "hidden-neurons",
      fmt::format("Descriptors of 256 that nets learned with the sigmoid, from {} random starts of "
                  "at most {} epochs:",
                  choice.seeds, choice.max_epochs),
      {{"descriptors", kDescriptors},
       {"seeds", choice.seeds},
       {"max_epochs", choice.max_epochs},
       {"fewest_that_reached_all", min_hidden_that_reached_all(rows)},
       {"rows", rows}},
      choice.options);
}

}  // namespace thinbench
