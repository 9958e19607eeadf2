// Thinning rules and nets as the harness sees them: an image, and the number of iterations.
#pragma once

#include <memory>
#include <vector>

#include "api/catalogue.hpp"
#include "harness/operation.hpp"

namespace thinbench {

/// Every rule with both borders, and the nets limited to one iteration.
[[nodiscard]] std::vector<Operation> thinning_family();

/// What changes the result of an operation.
struct ThinningCase {
  Border border = Border::background;
  int max_iterations = kUnlimited;
  std::shared_ptr<const NetModel> net = nullptr;  // instead of the rule's own
};

/// One operation; the table that it points to must outlive the result. With another net it has no
/// reference of its own.
[[nodiscard]] Operation thinning_operation(const detail::ThinningOperation& operation,
                                           const ThinningCase& options = {});

[[nodiscard]] std::unique_ptr<Job> thinning_job(std::unique_ptr<detail::ThinningState> state);

}  // namespace thinbench
