// Checks at the public edge of the library.
#pragma once

#include "core/views.hpp"

namespace thinbench {

enum class InPlace : bool { kRefused, kAllowed };

/// Throws std::invalid_argument where a size is negative, a stride is below the width, an image has
/// no data, the sizes differ, or the images overlap; being one and the same image is an overlap
/// unless it is allowed.
void check_views(const ConstByteView& source, const ConstByteView& destination, InPlace in_place);

}  // namespace thinbench
