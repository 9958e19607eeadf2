// Text to weights: every field is checked, and the first that is wrong is named. Weights to text:
// JSON laid out by hand, one neuron per line, and Table 1.
#include "training/weights_file.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/regular_file.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

/// A value in the file and the way to it, such as hidden[3].bias.
class Field {
 public:
  Field(const Json& json, const std::string& file, std::string name)
      : json_(json), file_(file), name_(std::move(name)) {}

  [[nodiscard]] Field member(const std::string& key) const {
    if (!json_.is_object()) fail("must be an object");
    Field found(json_.contains(key) ? json_.at(key) : json_, file_,
                name_.empty() ? key : name_ + "." + key);
    if (!json_.contains(key)) found.fail("is missing");
    return found;
  }

  [[nodiscard]] Field element(std::size_t i) const {
    return {json_.at(i), file_, name_ + "[" + std::to_string(i) + "]"};
  }

  /// The number of elements, which must lie between the two.
  [[nodiscard]] std::size_t count(std::size_t least, std::size_t most, const char* what) const {
    if (!json_.is_array()) fail("must be a list");
    const std::size_t size = json_.size();
    if (size >= least && size <= most) return size;
    const std::string range = least == most ? std::to_string(most)
                                            : std::to_string(least) + " to " + std::to_string(most);
    fail("has " + std::to_string(size) + " " + what + "; it must have " + range);
  }

  [[nodiscard]] float number() const {
    if (!json_.is_number()) fail("must be a number");
    const auto value = json_.get<double>();
    if (std::abs(value) > kLargestWeight) fail("is " + json_.dump() + "; the largest is 1e30");
    return static_cast<float>(value);
  }

  [[nodiscard]] std::int64_t integer() const {
    if (!json_.is_number_integer()) fail("must be an integer");
    if (json_.is_number_unsigned() && json_.get<std::uint64_t>() > INT64_MAX) fail("is too large");
    return json_.get<std::int64_t>();
  }

  [[nodiscard]] std::string text() const {
    if (!json_.is_string()) fail("must be a text");
    return json_.get<std::string>();
  }

  [[noreturn]] void fail(const std::string& problem) const {
    const std::string field = name_.empty() ? "the outermost value" : name_;
    throw std::runtime_error(file_ + ": " + field + " " + problem);
  }

 private:
  const Json& json_;
  const std::string& file_;
  std::string name_;
};

Neuron read_neuron(const Field& field) {
  Neuron neuron{};
  const Field weights = field.member("weights");
  const std::size_t count = weights.count(kNetInputs, kNetInputs, "numbers");
  for (std::size_t i = 0; i < count; ++i) neuron.weight[i] = weights.element(i).number();
  neuron.bias = field.member("bias").number();
  return neuron;
}

TwoLayerWeights read_two_layer(const Field& root) {
  TwoLayerWeights weights{};
  const Field hidden = root.member("hidden");
  const std::size_t count = hidden.count(kHiddenNeurons, kHiddenNeurons, "neurons");
  for (std::size_t j = 0; j < count; ++j) weights.hidden[j] = read_neuron(hidden.element(j));
  weights.output = read_neuron(root.member("output"));
  return weights;
}

ClusterNet read_net(const Field& field, int first, bool is_last) {
  constexpr int kEnd = kDescriptors - 1;
  if (field.member("first").integer() != first) {
    field.member("first").fail("must be " + std::to_string(first) +
                               ": the runs cover 0 to 255 in order");
  }
  const Field last_field = field.member("last");
  const std::int64_t last = last_field.integer();
  if (is_last && last != kEnd) last_field.fail("must be 255: the last run ends there");
  if (last < first || last > kEnd) {
    last_field.fail("must lie between " + std::to_string(first) + " and 255");
  }
  return {static_cast<int>(last), read_neuron(field)};
}

ClusterWeights read_cluster(const Field& root) {
  ClusterWeights weights{};
  const Field nets = root.member("nets");
  const std::size_t count = nets.count(1, kMaxClusterNets, "nets");
  int first = 0;
  for (std::size_t n = 0; n < count; ++n) {
    weights.nets[n] = read_net(nets.element(n), first, n + 1 == count);
    first = weights.nets[n].last + 1;
  }
  weights.count = static_cast<int>(count);
  return weights;
}

Json parse(const std::string& text, const std::string& name) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw std::runtime_error(name + ": not JSON, or truncated, at byte " +
                             std::to_string(error.byte) + " of " + std::to_string(text.size()));
  } catch (const Json::out_of_range&) {
    throw std::runtime_error(name + ": a number is too large to read");
  }
}

}  // namespace

AnyWeights parse_weights(const std::string& text, const std::string& name) {
  const Json json = parse(text, name);
  const Field root(json, name, "");
  const Field schema = root.member("schema");
  if (schema.integer() != 1) schema.fail("must be 1, the only version there is");
  const Field kind = root.member("kind");
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
