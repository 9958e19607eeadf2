// Widths of lines from distances to the background.
#pragma once

#include "thinbench/image_view.hpp"

namespace thinbench::detail {

/// Throws std::invalid_argument unless there is data with a stride of at least the width.
void check_distances(const View<const double>& distances);

}  // namespace thinbench::detail
