// Weights to text: JSON laid out by hand, a neuron a line, and Table 1.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "support/text.hpp"
#include "training/weights_file.hpp"

namespace thinbench {
namespace {

std::string opening(const char* kind, const std::string& made_by) {
  return std::string("{\n  \"schema\": 1,\n  \"kind\": \"") + kind +
         "\",\n  \"made_by\": " + nlohmann::json(made_by).dump() + ",\n";
}

std::vector<std::string> shortest_of(const float (&values)[kNetInputs]) {
  std::vector<std::string> texts;
  for (const float value : values) texts.push_back(shortest(value));
  return texts;
}

/// "weights": [...], "bias": ...
std::string neuron_fields(const Neuron& neuron) {
  return std::string("\"weights\": [") + joined(shortest_of(neuron.weight), ", ") +
         "], \"bias\": " + shortest(neuron.bias);
}

std::string net_object(const ClusterNet& net, int first) {
  return std::string("{\"first\": ") + std::to_string(first) +
         ", \"last\": " + std::to_string(net.last) + ", " + neuron_fields(net.neuron) + "}";
}

/// A list of objects, one a line.
std::string list(const std::vector<std::string>& objects) {
  return std::string("[\n    ") + joined(objects, ",\n    ") + "\n  ]";
}

/// A line of Table 1: `weights` cells, as many as there are columns, then the bias.
std::vector<std::string> table_row(const std::string& name, std::vector<std::string> weights,
                                   std::size_t columns, float bias) {
  weights.insert(weights.begin(), name);
  weights.resize(columns + 1);
  weights.push_back(shortest(bias));
  return weights;
}

}  // namespace

std::string weights_json(const TwoLayerWeights& weights, const std::string& made_by) {
  std::vector<std::string> hidden;
  for (const Neuron& neuron : weights.hidden)
    hidden.push_back(std::string("{") + neuron_fields(neuron) + "}");
  return opening("two_layer", made_by) + "  \"hidden\": " + list(hidden) + ",\n  \"output\": {" +
         neuron_fields(weights.output) + "}\n}\n";
}

std::string weights_json(const ClusterWeights& weights, const std::string& made_by) {
  std::vector<std::string> nets;
  int first = 0;
  for (int n = 0; n < weights.count; ++n) {
    nets.push_back(net_object(weights.nets[n], first));
    first = weights.nets[n].last + 1;
  }
  return opening("cluster", made_by) + "  \"nets\": " + list(nets) + "\n}\n";
}

std::string table_markdown(const HiddenLayerNet& net) {
  const std::size_t columns = std::max<std::size_t>(net.hidden.size(), kNetInputs);
  std::vector<std::string> head = {""};
  for (std::size_t i = 0; i < columns; ++i) head.push_back(std::string("W") + std::to_string(i));
  head.emplace_back("B");
  std::vector<std::vector<std::string>> rows;
  for (const Neuron& neuron : net.hidden) {
    const std::string name = std::string("Hid") + std::to_string(rows.size());
    rows.push_back(table_row(name, shortest_of(neuron.weight), columns, neuron.bias));
  }
  std::vector<std::string> output;
  for (const float weight : net.output_weight) output.push_back(shortest(weight));
  rows.push_back(table_row("Out", std::move(output), columns, net.output_bias));
  return markdown_table(head, rows);
}

std::string table_markdown(const TwoLayerWeights& weights) {
  return table_markdown(to_net(weights));
}

}  // namespace thinbench
