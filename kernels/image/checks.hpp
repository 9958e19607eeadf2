// Checks at the public edge, before anything is allocated or written.
#pragma once

#include <string>

#include "thinbench/image_view.hpp"

namespace thinbench::detail {

/// Throws std::invalid_argument with this text unless the condition holds.
void require(bool holds, const std::string& otherwise);

/// "510 x 412", for texts.
[[nodiscard]] std::string size_text(Index width, Index height);

/// Each throws std::invalid_argument: for a negative size, for more pixels than 2^40, and for a
/// number of threads that is not in [1, kMaxThreads].
void require_size(Index width, Index height);
void require_max_pixels(Index width, Index height);
void require_threads(int threads);

}  // namespace thinbench::detail
