#include "cli/weights_option.hpp"

#include <stdexcept>

#include "training/weights_file.hpp"

namespace thinbench {

std::shared_ptr<const NetModel> net_from_file(const detail::ThinningOperation& operation,
                                              const std::string& path) {
  if (path.empty()) return nullptr;
  const std::string name(operation.name);
  if (!operation.is_net) {
    throw std::runtime_error("--weights: " + name + " is no net and takes none");
  }
  const AnyWeights weights = read_weights(path);
  const bool wants_cluster = operation.rule == Rule::net_single_layer_cluster;
  if (wants_cluster != std::holds_alternative<ClusterWeights>(weights)) {
    const std::string wanted = wants_cluster ? "cluster" : "two_layer";
    throw std::runtime_error(path + ": holds the wrong kind of weights; " + name + " needs " +
                             wanted);
  }
  if (wants_cluster) return cluster_net(std::get<ClusterWeights>(weights));
  const bool is_linear = operation.rule == Rule::net_two_layer_linear;
  return two_layer_net(std::get<TwoLayerWeights>(weights),
                       is_linear ? Activation::linear : Activation::sigmoid);
}

}  // namespace thinbench
