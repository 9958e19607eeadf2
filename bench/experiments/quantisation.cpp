#include "experiments/quantisation.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "support/text.hpp"

namespace thinbench {
namespace {

constexpr int kMostBits = 8;

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

QuantisationRow measure(Quantisation way, int bits) {
  const KeepTable rule = keep_table_of_rule();
  const HiddenLayerNet net = quantised(to_net(kPaperTwoLayer), way, bits);
  float largest = 0;
  for_each_number(net, [&](float value) { largest = std::max(largest, std::abs(value)); });
  return {way, bits, agreement(table_of(net, Activation::sigmoid), rule),
          agreement(table_of(net, Activation::linear), rule),
          static_cast<int>(std::ldexp(largest, bits))};
}

const char* name_of(Quantisation way) {
  return way == Quantisation::round ? "rounded" : "truncated";
}

}  // namespace

HiddenLayerNet quantised(const HiddenLayerNet& net, Quantisation way, int bits) {
  HiddenLayerNet result = net;
  for_each_number(result, [&](float& value) { value = quantised(value, way, bits); });
  return result;
}

std::vector<QuantisationRow> run_quantisation() {
  std::vector<QuantisationRow> rows;
  for (const Quantisation way : {Quantisation::round, Quantisation::truncate}) {
    for (int bits = 0; bits <= kMostBits; ++bits) rows.push_back(measure(way, bits));
  }
  return rows;
}

ExperimentReport quantisation_report(const std::vector<QuantisationRow>& rows) {
  const KeepTable rule = keep_table_of_rule();
  const HiddenLayerNet as_published = to_net(kPaperTwoLayer);
  nlohmann::ordered_json json = {
      {"descriptors", kDescriptors},
      {"as_published",
       {{"right_sigmoid", agreement(table_of(as_published, Activation::sigmoid), rule)},
        {"right_linear", agreement(table_of(as_published, Activation::linear), rule)}}},
      {"rows", nlohmann::ordered_json::array()}};
  std::vector<std::vector<std::string>> cells;
  for (const QuantisationRow& row : rows) {
    json["rows"].push_back({{"weights", name_of(row.way)},
                            {"fractional_bits", row.fractional_bits},
                            {"right_sigmoid", row.right_sigmoid},
                            {"right_linear", row.right_linear},
                            {"largest_integer", row.largest_integer}});
    cells.push_back({name_of(row.way), std::to_string(row.fractional_bits),
                     std::to_string(row.right_sigmoid), std::to_string(row.right_linear),
                     std::to_string(row.largest_integer)});
  }
  return {
      experiment_json("quantisation", json),
      "Descriptors of 256 on which the net of Table 1 is correct, its weights in fixed point:\n\n" +
          markdown_table({"Weights", "Fractional bits", "Sigmoid", "Linear threshold",
                          "Largest weight as an integer"},
                         cells)};
}

}  // namespace thinbench
