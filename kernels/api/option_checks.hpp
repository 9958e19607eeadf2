// Checks of options at the public interface. All throw std::invalid_argument, with one sentence.
#pragma once

#include "api/catalogue.hpp"

namespace thinbench::detail {

/// Threads out of range, or a variant that cannot run here on images of this width.
void check_variant(const VariantInfo& variant, Index width, const Options& options);

/// A negative size, a side above 2^29 or more than 2^32 pixels.
void check_regions_size(Index width, Index height);

/// A border, max_iterations, directions or a net out of range or not for this operation.
void check_thinning_options(const ThinningOperation& operation, const Options& options);

/// Options for thinning only.
void check_no_thinning_options(std::string_view operation, const Options& options);

}  // namespace thinbench::detail
