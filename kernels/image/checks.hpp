// What every plan refuses before it takes memory.
#pragma once

#include <string>

#include "dispatch/variant_choice.hpp"

namespace thinbench {

/// Throws std::invalid_argument with this text unless the condition holds.
void require(bool holds, const std::string& otherwise);

/// "510 x 412", for texts.
[[nodiscard]] std::string size_text(Index width, Index height);

/// Each throws std::invalid_argument: for a negative size, more pixels than 2^40, a number of
/// threads not in [1, kMaxThreads], and a variant that cannot run here on images of this width.
void require_size(Index width, Index height);
void require_max_pixels(Index width, Index height);
void require_threads(int threads);
void require_available(const VariantFacts& variant, Index width);

}  // namespace thinbench
