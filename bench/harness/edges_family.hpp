// Edge operators as the harness sees them: a grey image in, an image of edges out.
#pragma once

#include <memory>
#include <vector>

#include "api/catalogue.hpp"
#include "harness/operation.hpp"

namespace thinbench {

/// With the default thresholds.
[[nodiscard]] std::vector<Operation> edges_family();

/// The reference of an edge operator with these thresholds; a brightness threshold of -1 omits the
/// second.
[[nodiscard]] JobMaker edges_reference(EdgeOperator op, const EdgeThresholds& thresholds);

/// One operation with these thresholds; it must outlive the result.
[[nodiscard]] Operation edges_operation(const detail::EdgeOperation& operation,
                                        const EdgeThresholds& thresholds);

}  // namespace thinbench
