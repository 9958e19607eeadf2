// The catalogue of thinning rules. CONTRIBUTING.md shows how to add one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "thinbench/enumeration.hpp"

namespace thinbench {

enum class Rule : std::uint8_t {
  naccache_shinghal,
  zhang_suen,
  zhang_suen_skimage,
  guo_hall,
  guo_hall_skimage,
  lu_wang,
  spta,
  spta_directional,
  mb2,
  midpoint_scan,
  net_two_layer_sigmoid,
  net_two_layer_rounded,
  net_two_layer_linear,
  net_single_layer_cluster,
};

struct RuleInfo {
  Rule rule;
  std::string_view name;
  std::string_view operation;  // its name as an operation, for example in results
  /// How far the effect of a pixel advances in an iteration, in rows and in columns: one pixel per
  /// sub-iteration, two where a rule reads 5 x 5 pixels. 0: without a bound, as in sequential
  /// scans.
  int reach;
  std::string_view description;
};

/// In the order of the enumeration.
inline constexpr std::array kRules = {
    RuleInfo{Rule::naccache_shinghal, "naccache_shinghal", "thin_naccache_shinghal", 1,
             "modified Naccache-Shinghal rule, all removals of an iteration at once, as published"},
    RuleInfo{Rule::zhang_suen, "zhang_suen", "thin_zhang_suen", 2,
             "Zhang and Suen 1984, two sub-iterations; loses 2 x 2 blocks"},
    RuleInfo{Rule::zhang_suen_skimage, "zhang_suen_skimage", "thin_zhang_suen_skimage", 2,
             "scikit-image's skeletonize: zhang_suen with 31 decisions changed"},
    RuleInfo{Rule::guo_hall, "guo_hall", "thin_guo_hall", 2,
             "Guo and Hall 1989, two sub-iterations; keeps topology"},
    RuleInfo{Rule::guo_hall_skimage, "guo_hall_skimage", "thin_guo_hall_skimage", 2,
             "guo_hall with its sub-iterations exchanged: scikit-image's thin, bwmorph; keeps "
             "topology"},
    RuleInfo{Rule::lu_wang, "lu_wang", "thin_lu_wang", 2,
             "Lu and Wang 1986, as Zhang and Suen but slanted lines keep their length"},
    RuleInfo{Rule::spta, "spta", "thin_spta", 0,
             "Naccache and Shinghal's SPTA as published, two sequential scans per iteration, one "
             "thread; keeps topology"},
    RuleInfo{Rule::spta_directional, "spta_directional", "thin_spta_directional", 4,
             "Naccache and Shinghal's SPTA, one direction after another; keeps topology"},
    RuleInfo{Rule::mb2, "mb2", "thin_mb2", 2,
             "Bernard and Manzanera 1999, fully parallel, 5 x 5; keeps topology"},
    RuleInfo{Rule::midpoint_scan, "midpoint_scan", "skeleton_scan", 0,
             "the paper's own method: midpoints of foreground runs along rows, columns and both "
             "diagonals"},
    RuleInfo{Rule::net_two_layer_sigmoid, "net_two_layer_sigmoid", "net_two_layer_sigmoid", 1,
             "the two-layer net of Table 1 with sigmoid (1); hidden values across lanes agree "
             "within 2 units in the last place, outputs within 9"},
    RuleInfo{Rule::net_two_layer_rounded, "net_two_layer_rounded", "net_two_layer_rounded", 1,
             "net_two_layer_sigmoid with weights rounded to integers: not quite the rule"},
    RuleInfo{Rule::net_two_layer_linear, "net_two_layer_linear", "net_two_layer_linear", 1,
             "the two-layer net of Table 1 with linear threshold (2); all values agree bit for "
             "bit"},
    RuleInfo{Rule::net_single_layer_cluster, "net_single_layer_cluster", "net_single_layer_cluster",
             1, "the cluster of twelve single-layer nets, equations (5) to (7)"},
};

/// This and rule_name throw std::invalid_argument for a value outside the enumeration.
[[nodiscard]] constexpr const RuleInfo& rule_info(Rule rule) {
  return detail::entry_of(kRules, rule, "rule");
}

[[nodiscard]] constexpr std::string_view rule_name(Rule rule) {
  return rule_info(rule).name;
}

/// The rule of this name, or of the operation of this name.
[[nodiscard]] constexpr std::optional<Rule> rule_from_name(std::string_view name) {
  for (const RuleInfo& info : kRules) {
    if (info.name == name || info.operation == name) return info.rule;
  }
  return std::nullopt;
}

}  // namespace thinbench
