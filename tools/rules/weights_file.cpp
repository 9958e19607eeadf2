// Every field is checked, and the first that is wrong is named.
#include "rules/weights_file.hpp"

#include <cmath>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "support/file_bytes.hpp"
#include "support/json_field.hpp"

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
  constexpr int kEnd = 255;
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
  return parse_weights(std::string(read_file(path, kMaxJsonBytes).text()), path);
}

}  // namespace thinbench
