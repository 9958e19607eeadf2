#include "cli/weights_option.hpp"

#include <stdexcept>

#include "nets/make_model.hpp"
#include "training/weights_file.hpp"

namespace thinbench {

std::shared_ptr<const RuleModel> model_from_file(const ThinningOperation& operation,
                                                 const std::string& path) {
  if (path.empty()) return nullptr;
  const std::string name(operation.name);
  if (operation.default_model == nullptr) {
    throw std::runtime_error("--weights: " + name + " is no net and takes none");
  }
  const AnyWeights weights = read_weights(path);
  const RuleModel& own = operation.default_model();
  const bool wants_cluster = own.cluster.count > 0;
  if (wants_cluster != std::holds_alternative<ClusterWeights>(weights)) {
    const std::string wanted = wants_cluster ? "cluster" : "two_layer";
    throw std::runtime_error(path + ": holds the wrong kind of weights; " + name + " needs " +
                             wanted);
  }
  return std::make_shared<const RuleModel>(
      wants_cluster ? cluster_model(std::get<ClusterWeights>(weights))
                    : two_layer_model(std::get<TwoLayerWeights>(weights), own.activation));
}

}  // namespace thinbench
