// Edge operators as the harness sees them: a grey image in, an image of edges out.
#pragma once

#include <memory>
#include <vector>

#include "edges/plan.hpp"
#include "harness/operation.hpp"

namespace thinbench {

/// With the default thresholds.
[[nodiscard]] std::vector<Operation> edges_family();

/// The reference of an edge operation with these thresholds; a p2 of -1 leaves the second out.
[[nodiscard]] JobMaker edges_reference(std::string_view operation,
                                       const EdgeThresholds& thresholds);

/// One operation with these thresholds; it must outlive the result.
[[nodiscard]] Operation edges_operation(const EdgeOperation& operation,
                                        const EdgeThresholds& thresholds);

}  // namespace thinbench
