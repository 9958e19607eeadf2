#include "techniques/study_rules.hpp"

#include <memory>
#include <string>

#include "rules/trained_cluster.hpp"

namespace thinbench::detail::study {
namespace {

Rule make_net(const Rule& by_table, const NetModel& model, std::string_view name) {
  auto body = std::make_shared<NetBody>();
  static_cast<RuleBody&>(*body) = *body_of(by_table);
  body->name = name;
  body->model = model;
  return RuleAccess::make(std::move(body));
}

Rule make_net(const TwoLayerWeights& weights, Activation activation, std::string_view name) {
  const Rule by_table = Rule::from_net(weights, activation);
  return make_net(by_table, make_net_model(weights, activation, by_table.sub_iterations().front()),
                  name);
}

Rule make_net(const ClusterWeights& weights, std::string_view name) {
  return make_net(Rule::from_net(weights), make_net_model(weights), name);
}

}  // namespace

Rule make_net(const TwoLayerWeights& weights, Activation activation) {
  return make_net(weights, activation, "net");
}

Rule make_net(const ClusterWeights& weights) {
  return make_net(weights, "net");
}

Rule make_rule(StudyRule rule) {
  const StudyRuleInfo& info = kStudyRules.at(static_cast<std::size_t>(rule));
  switch (rule) {
    case StudyRule::net_two_layer_sigmoid:
      return make_net(kPaperTwoLayer, Activation::sigmoid, info.name);
    case StudyRule::net_two_layer_rounded:
      return make_net(kRoundedTwoLayer, Activation::sigmoid, info.name);
    case StudyRule::net_two_layer_linear:
      return make_net(kPaperTwoLayer, Activation::linear, info.name);
    case StudyRule::net_single_layer_cluster:
      return make_net(kTrainedCluster, info.name);
    default:
      break;
  }
  auto body = std::make_shared<SptaBody>();
  body->name = info.name;
  return RuleAccess::make(std::move(body));
}

}  // namespace thinbench::detail::study
