// The variant that a user asked for, or the reason why there is none, in words that help.
#pragma once

#include <string>

#include "thinbench/thinning.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {

/// Throws UsageError where no variant has this technique, instruction set and kind of threads,
/// std::runtime_error where none of them runs here or on pictures of this width.
[[nodiscard]] const ThinningVariant& variant_for(const ThinningOperation& operation, Index width,
                                                 const Options& options);
[[nodiscard]] const EdgeVariant& variant_for(const EdgeOperation& operation, Index width,
                                             const Options& wish);
[[nodiscard]] const HolesVariant& variant_for(const HolesOperation& operation, Index width,
                                              const Options& wish);

}  // namespace thinbench
