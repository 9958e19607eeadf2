// Checks of stacks of images at the public edge of the library.
#pragma once

#include "thinbench/image_view.hpp"

namespace thinbench::detail {

/// Throws std::invalid_argument where a count or a size is negative, a row or an image does not fit
/// its stride, a stack spans more memory than there is or has no data, counts or sizes differ, or
/// the stacks overlap without being one and the same. Stacks whose images lie by turns in one
/// buffer count as overlapping.
void check_stacks(const ConstStackView& source, const ConstStackView& destination);

}  // namespace thinbench::detail
