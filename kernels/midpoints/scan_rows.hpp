// The variants of the scanning skeleton.
#pragma once

#include <span>

#include "thinning/variant.hpp"

namespace thinbench::detail {

[[nodiscard]] std::span<const ThinningVariant> scan_rows();

}  // namespace thinbench::detail
