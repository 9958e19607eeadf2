// The variant that a user asked for, or the reason why there is none, in words that help.
#pragma once

#include <string>

#include "thinbench.hpp"
#include "thinbench_edges.hpp"
#include "thinbench_holes.hpp"

namespace thinbench {

/// Throws UsageError where no variant has this technique, instruction set and kind of threads,
/// std::runtime_error where none of them runs here or on pictures of this width.
[[nodiscard]] const ThinningVariant& variant_for(const ThinningOperation& operation, Index width,
                                                 const ThinningOptions& options);
[[nodiscard]] const EdgeVariant& variant_for(const EdgeOperation& operation, Index width,
                                             const VariantRequest& wish);
[[nodiscard]] const HolesVariant& variant_for(const HolesOperation& operation, Index width,
                                              const VariantRequest& wish);

}  // namespace thinbench
