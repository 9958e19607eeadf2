// Thinning rules and nets as the harness sees them: an image, and the number of passes it took.
#pragma once

#include <memory>
#include <vector>

#include "harness/operation.hpp"
#include "thinning/plan.hpp"

namespace thinbench {

[[nodiscard]] std::vector<Operation> thinning_family();

/// One operation; the table that it points to must outlive the result. Its reference is looked up
/// by name, and only when it is needed.
[[nodiscard]] Operation thinning_operation(const ThinningOperation& operation);

[[nodiscard]] std::unique_ptr<Job> thinning_job(ThinningPlan plan);

}  // namespace thinbench
