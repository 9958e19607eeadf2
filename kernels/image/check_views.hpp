// Checks at the public edge of the library.
#pragma once

#include "thinbench/image_view.hpp"

namespace thinbench::detail {

enum class InPlace : bool { rejected, allowed };

/// Throws std::invalid_argument where a size is negative, a stride is below the width, an image has
/// no data, the sizes differ, or the images overlap; being one and the same image is an overlap
/// unless it is allowed.
void check_views(const ConstImageView& source, const ConstImageView& destination, InPlace in_place);

}  // namespace thinbench::detail
