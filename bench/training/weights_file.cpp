// Text to weights: every field is checked, and the first that is wrong is named. Weights to text:
// JSON laid out by hand, one neuron per line, and Table 1.
#include "training/weights_file.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/json_field.hpp"
#include "support/regular_file.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

float number(const JsonField& field) {
  if (!field.json().is_number()) field.fail("must be a number");
  const auto value = field.json().get<double>();
  if (std::abs(value) > kLargestWeight) {
    field.fail("is " + field.json().dump() + "; the largest is 1e30");
  }
  return static_cast<float>(value) + 0.0F;  // -0 becomes 0, which is written without a sign
}

Neuron read_neuron(const JsonField& field) {
  Neuron neuron{};
  const JsonField weights = field.member("weights");
  const std::size_t count = weights.count(kNetInputs, kNetInputs, "numbers");
  for (std::size_t i = 0; i < count; ++i) neuron.weight[i] = number(weights.element(i));
  neuron.bias = number(field.member("bias"));
  return neuron;
}

TwoLayerWeights read_two_layer(const JsonField& root) {
  TwoLayerWeights weights{};
  const JsonField hidden = root.member("hidden");
  const std::size_t count = hidden.count(kHiddenNeurons, kHiddenNeurons, "neurons");
  for (std::size_t j = 0; j < count; ++j) weights.hidden[j] = read_neuron(hidden.element(j));
  weights.output = read_neuron(root.member("output"));
  return weights;
}

ClusterNet read_net(const JsonField& field, int first, bool is_last) {
  constexpr int kEnd = kDescriptors - 1;
  if (field.member("first").integer() != first) {
    field.member("first").fail("must be " + std::to_string(first) +
                               ": the runs cover 0 to 255 in order");
  }
  const JsonField last_field = field.member("last");
  const std::int64_t last = last_field.integer();
  if (is_last && last != kEnd) last_field.fail("must be 255: the last run ends there");
  if (last < first || last > kEnd) {
    last_field.fail("must lie between " + std::to_string(first) + " and 255");
  }
  return {static_cast<int>(last), read_neuron(field)};
}

ClusterWeights read_cluster(const JsonField& root) {
  ClusterWeights weights{};
  const JsonField nets = root.member("nets");
  const std::size_t count = nets.count(1, kMaxClusterNets, "nets");
  int first = 0;
  for (std::size_t n = 0; n < count; ++n) {
    weights.nets[n] = read_net(nets.element(n), first, n + 1 == count);
    first = weights.nets[n].last + 1;
  }
  weights.count = static_cast<int>(count);
  return weights;
}

}  // namespace

AnyWeights parse_weights(const std::string& text, const std::string& name) {
  const Json json = parse_json(text, name);
  const JsonField root(json, name, "");
  const JsonField schema = root.member("schema");
  if (schema.integer() != 1) schema.fail("must be 1, the only version there is");
  const JsonField kind = root.member("kind");
  if (kind.text() == "two_layer") return read_two_layer(root);
  if (kind.text() == "cluster") return read_cluster(root);
  kind.fail("must be \"two_layer\" or \"cluster\"");
}

AnyWeights read_weights(const std::string& path) {
  constexpr std::size_t max_bytes = 1'000'000;
  return parse_weights(read_whole_file(path, max_bytes), path);
}

namespace {

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

std::string table_markdown(const TwoLayerWeights& weights) {
  return table_markdown(to_net(weights));
}

}  // namespace thinbench
