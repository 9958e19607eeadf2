#include "cli/thinning_request.hpp"

#include <climits>
#include <memory>
#include <variant>

#include "cli/arguments.hpp"
#include "cli/names.hpp"
#include "cli/usage.hpp"
#include "rules/weights_file.hpp"

namespace thinbench {
namespace {

/// The directions named in a list such as "rows,columns"; all where the list is empty.
Directions directions_named(Rule rule, const std::string& list) {
  if (list.empty()) return {};
  if (rule != Rule::midpoint_scan) {
    throw UsageError("--directions: " + std::string(rule_info(rule).operation) +
                     " is not a scan and has no directions");
  }
  Directions directions = kNoDirections;
  std::size_t end = 0;
  for (std::size_t start = 0; end != std::string::npos; start = end + 1) {
    end = list.find(',', start);
    const std::string name = list.substr(start, end - start);
    if (name.empty()) {
      throw UsageError("--directions: '" + list + "' has an empty name; known: " +
                       enumeration({kDirectionNames.begin(), kDirectionNames.end()}));
    }
    directions.add(direction_named(name));
  }
  return directions;
}

/// The net that `rule` makes of the weights in a file; nullptr where no file is named.
std::shared_ptr<const NetModel> net_from_file(Rule rule, const std::string& path) {
  if (path.empty()) return nullptr;
  const std::string name(rule_info(rule).operation);
  if (!name.starts_with("net_")) {
    throw UsageError("--weights: " + name + " is not a net and has no weights");
  }
  const AnyWeights weights = read_weights(path);
  const bool wants_cluster = rule == Rule::net_single_layer_cluster;
  if (wants_cluster != std::holds_alternative<ClusterWeights>(weights)) {
    const std::string wanted = wants_cluster ? "cluster" : "two_layer";
    throw std::runtime_error(path + ": holds the wrong kind of weights; " + name + " needs " +
                             wanted);
  }
  if (wants_cluster) return cluster_net(std::get<ClusterWeights>(weights));
  const bool is_linear = rule == Rule::net_two_layer_linear;
  return two_layer_net(std::get<TwoLayerWeights>(weights),
                       is_linear ? Activation::linear : Activation::sigmoid);
}

}  // namespace

void add_thinning_options(CLI::App& app, ThinningRequest& request) {
  app.add_option("--weights", request.weights, "Weights of a net, made by 'thinbench-study train'")
      ->check(not_empty())
      ->type_name("FILE");
  app.add_option_function<std::string>(
         "--border",
         [&request](const std::string& name) { request.how.border = border_named(name); },
         "background: outside the image all is background; keep: the outermost rows and columns "
         "never change, as in OpenCV (default: background)")
      ->check(not_empty())
      ->type_name("NAME");
  app.add_option(
         "--directions", request.directions,
         "Where skeleton_scan looks: rows, columns, diagonals, antidiagonals (default: all)")
      ->check(not_empty())
      ->type_name("NAME,...");
  app.add_option("--max-iterations", request.how.max_iterations,
                 "Stop after N iterations (default: when nothing changes any more)")
      ->check(whole_number(1, INT_MAX))
      ->type_name("N");
}

Options options_for(Rule rule, const ThinningRequest& request) {
  Options how = request.how;
  how.net = net_from_file(rule, request.weights);
  how.directions = directions_named(rule, request.directions);
  return how;
}

std::string thinning_words(const ThinningRequest& request) {
  std::string words;
  const auto add = [&words](const char* option, std::string_view value) {
    words.append(" ").append(option).append(" ").append(value);
  };
  if (request.how.border != Border::background) add("--border", border_name(request.how.border));
  if (request.how.max_iterations != kUnlimited) {
    add("--max-iterations", std::to_string(request.how.max_iterations));
  }
  if (!request.weights.empty()) add("--weights", request.weights);
  if (!request.directions.empty()) add("--directions", request.directions);
  return words;
}

}  // namespace thinbench
