// Checks of options at the public interface. All throw std::invalid_argument with a one-line
// message.
#pragma once

#include "api/catalogue.hpp"

namespace thinbench::detail {

/// Rejects threads out of range, and a variant that cannot run on this machine at this width.
void check_variant(const VariantInfo& variant, Index width, const Options& options);

/// Rejects a negative size, a side above 2^29 and more than 2^32 pixels.
void check_regions_size(Index width, Index height);

/// The same for images of labels: at most 2^31 pixels.
void check_label_size(Index width, Index height);

/// Rejects a side above kMaxDistanceSide.
void check_distance_size(Index width, Index height);

/// Rejects a border, max_iterations, directions or net that is out of range or not for this
/// operation.
void check_thinning_options(const ThinningOperation& operation, const Options& options);

/// Rejects options that only thinning has.
void check_no_thinning_options(std::string_view operation, const Options& options);

}  // namespace thinbench::detail
