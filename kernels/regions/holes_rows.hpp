// The variants of the operations on objects and holes.
#pragma once

#include "regions/variant.hpp"

namespace thinbench::detail {

/// Holes and components.
[[nodiscard]] std::span<const HolesVariant> region_rows();
/// Euler numbers.
[[nodiscard]] std::span<const HolesVariant> euler_rows();
/// Filled images.
[[nodiscard]] std::span<const HolesVariant> fill_rows();

}  // namespace thinbench::detail
