// Checks at the public interface, before anything is allocated or written. All throw
// std::invalid_argument.
#pragma once

#include <string>

#include "thinbench/image_view.hpp"

namespace thinbench::detail {

/// Throws with this text unless the condition holds.
void require(bool holds, const std::string& otherwise);

/// "510 x 412", for texts.
[[nodiscard]] std::string size_text(Index width, Index height);

/// A negative size; more than 2^40 pixels; a number of threads outside [1, kMaxThreads].
void require_size(Index width, Index height);
void require_max_pixels(Index width, Index height);
void require_threads(int threads);

enum class InPlace : bool { rejected, allowed };

/// A negative size, a stride below the width, an image without data, sizes that differ, or an
/// overlap. `in_place` says whether both may be the same image.
void check_views(const ConstImageView& source, const ConstImageView& destination, InPlace in_place);

/// A negative count or size, a row or an image that does not fit its stride, a stack that exceeds
/// the address space or has no data, counts or sizes that differ, or a partial overlap. Stacks with
/// interleaved images in one buffer count as overlapping. Allocates nothing unless it throws.
void check_stacks(const ConstStackView& source, const ConstStackView& destination);

}  // namespace thinbench::detail
