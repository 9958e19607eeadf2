// Rules that only the study has: nets, whose pixels are computed by their arithmetic, and
// sequential SPTA, which is no function of the pixels before an iteration.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "compile/rule_body.hpp"
#include "techniques/net_model.hpp"

namespace thinbench::detail::study {

enum class StudyRule : std::uint8_t {
  spta,
  net_two_layer_sigmoid,
  net_two_layer_rounded,
  net_two_layer_linear,
  net_single_layer_cluster,
};

struct StudyRuleInfo {
  StudyRule rule;
  std::string_view name;
  std::string_view operation;
  std::string_view description;
};

/// In the order of the enumeration.
inline constexpr std::array kStudyRules = {
    StudyRuleInfo{StudyRule::spta, "spta", "thin_spta",
                  "Naccache and Shinghal's SPTA as published, two sequential scans per iteration, "
                  "one thread; keeps topology"},
    StudyRuleInfo{StudyRule::net_two_layer_sigmoid, "net_two_layer_sigmoid",
                  "net_two_layer_sigmoid",
                  "the two-layer net of Table 1 with sigmoid (1); hidden values across lanes agree "
                  "within 2 units in the last place, outputs within 9"},
    StudyRuleInfo{StudyRule::net_two_layer_rounded, "net_two_layer_rounded",
                  "net_two_layer_rounded",
                  "net_two_layer_sigmoid with weights rounded to integers: not quite the rule"},
    StudyRuleInfo{StudyRule::net_two_layer_linear, "net_two_layer_linear", "net_two_layer_linear",
                  "the two-layer net of Table 1 with linear threshold (2); all values agree bit "
                  "for bit"},
    StudyRuleInfo{StudyRule::net_single_layer_cluster, "net_single_layer_cluster",
                  "net_single_layer_cluster",
                  "the cluster of twelve single-layer nets, equations (5) to (7)"},
};

/// A net runs by its table, like any rule, and by its arithmetic.
struct NetBody final : RuleBody {
  NetModel model;
};
/// Runs by make_spta() alone.
struct SptaBody final : RuleBody {};

// Rules for the states and variants of techniques.
[[nodiscard]] Rule make_rule(StudyRule rule);
[[nodiscard]] Rule make_net(const TwoLayerWeights& weights, Activation activation);
[[nodiscard]] Rule make_net(const ClusterWeights& weights);

}  // namespace thinbench::detail::study
