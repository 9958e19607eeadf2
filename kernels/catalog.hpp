// The one place that lists operations. Tests, benchmarks and programs walk these tables.
#pragma once

#include <span>
#include <string_view>

#include "edges/variant.hpp"
#include "regions/variant.hpp"
#include "localise/variant.hpp"
#include "thinning/variant.hpp"

namespace thinbench {

[[nodiscard]] std::span<const ThinningOperation> thinning_operations();

[[nodiscard]] std::span<const EdgeOperation> edge_operations();

[[nodiscard]] std::span<const HolesOperation> holes_operations();

/// The paper's whole chain.
[[nodiscard]] const LocaliseOperation& localise_operation();

/// The operation of this name, or nullptr.
[[nodiscard]] const ThinningOperation* find_thinning_operation(std::string_view name);
[[nodiscard]] const EdgeOperation* find_edge_operation(std::string_view name);
[[nodiscard]] const HolesOperation* find_holes_operation(std::string_view name);

}  // namespace thinbench
