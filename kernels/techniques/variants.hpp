// Every operation with all its variants: those of the product, and in front of them the techniques
// that the study compares them with. The product never uses these.
#pragma once

#include <span>

#include "distance/state.hpp"
#include "edges/state.hpp"
#include "graph/state.hpp"
#include "localise/state.hpp"
#include "midpoints/state.hpp"
#include "techniques/study_rules.hpp"
#include "thinning/operations.hpp"

namespace thinbench::detail::study {

// All live as long as the program.

/// Those of the product, then those of kStudyRules.
[[nodiscard]] std::span<const ThinningOperation> thinning_operations();
[[nodiscard]] std::span<const EdgeOperation> edge_operations();
[[nodiscard]] const DistanceOperation& distance_operation();
[[nodiscard]] const GraphOperation& graph_operation();
[[nodiscard]] const MidpointOperation& midpoint_operation();

/// Throws std::invalid_argument for a value outside the enumeration.
[[nodiscard]] const ThinningOperation& operation_of(BuiltInRule rule);
[[nodiscard]] const ThinningOperation& operation_of(StudyRule rule);

/// All variants of any rule.
[[nodiscard]] std::vector<ThinningVariant> all_variants(const RuleBody& rule);

struct TechniqueInfo {
  std::string_view name;
  std::string_view description;
};

/// What a technique does, of the product or of the study. Throws std::logic_error for an unknown
/// name.
[[nodiscard]] const TechniqueInfo& technique_info(std::string_view name);

}  // namespace thinbench::detail::study
