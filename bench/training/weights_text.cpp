// JSON laid out by hand, one neuron per line, and Table 1.
#include "training/weights_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/text.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

std::string file_of(const char* kind, const std::string& made_by, const std::string& nets) {
  return fmt::format("{{\n  \"schema\": 1,\n  \"kind\": \"{}\",\n  \"made_by\": {},\n  {}\n}}\n",
                     kind, Json(made_by).dump(), nets);
}

std::vector<std::string> shortest_of(const float (&values)[kNetInputs]) {
  std::vector<std::string> texts;
  for (const float value : values) texts.push_back(fmt::to_string(value));
  return texts;
}

std::string neuron_fields(const Neuron& neuron) {
  return fmt::format("\"weights\": [{}], \"bias\": {}", fmt::join(neuron.weight, ", "),
                     neuron.bias);
}

/// A list of objects, one per line.
std::string list(const std::vector<std::string>& objects) {
  return fmt::format("[\n    {{{}}}\n  ]", fmt::join(objects, "},\n    {"));
}

/// A line of Table 1: `weights` cells, as many as there are columns, then the bias.
std::vector<std::string> table_row(const std::string& name, std::vector<std::string> weights,
                                   std::size_t columns, float bias) {
  weights.insert(weights.begin(), name);
  weights.resize(columns + 1);
  weights.push_back(fmt::to_string(bias));
  return weights;
}

}  // namespace

std::string weights_json(const TwoLayerWeights& weights, const std::string& made_by) {
  std::vector<std::string> hidden;
  for (const Neuron& neuron : weights.hidden) hidden.push_back(neuron_fields(neuron));
  return file_of("two_layer", made_by,
                 fmt::format("\"hidden\": {},\n  \"output\": {{{}}}", list(hidden),
                             neuron_fields(weights.output)));
}

std::string weights_json(const ClusterWeights& weights, const std::string& made_by) {
  std::vector<std::string> nets;
  int first = 0;
  for (int n = 0; n < weights.count; ++n) {
    const ClusterNet& net = weights.nets[n];
    nets.push_back(
        fmt::format("\"first\": {}, \"last\": {}, {}", first, net.last, neuron_fields(net.neuron)));
    first = net.last + 1;
  }
  return file_of("cluster", made_by, "\"nets\": " + list(nets));
}

std::string table_markdown(const HiddenLayerNet& net) {
  const std::size_t columns = std::max<std::size_t>(net.hidden.size(), kNetInputs);
  std::vector<std::string> head = {""};
  for (std::size_t i = 0; i < columns; ++i) head.push_back(fmt::format("W{}", i));
  head.emplace_back("B");
  std::vector<std::vector<std::string>> rows;
  for (const Neuron& neuron : net.hidden) {
    rows.push_back(table_row(fmt::format("Hid{}", rows.size()), shortest_of(neuron.weight), columns,
                             neuron.bias));
  }
  std::vector<std::string> output;
  for (const float weight : net.output_weight) output.push_back(fmt::to_string(weight));
  rows.push_back(table_row("Out", std::move(output), columns, net.output_bias));
  return markdown_table(head, rows);
}

}  // namespace thinbench
