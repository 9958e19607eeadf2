// Thinning of many small images as the harness sees it: an input is a stack of square images.
#pragma once

#include <vector>

#include "harness/operation.hpp"

namespace thinbench {

/// An input of width W and height H holds H / W images of W x W pixels, one below the other; rows
/// that are left over become background. Variants take the images one by one or as a batch.
[[nodiscard]] std::vector<Operation> batch_family();

}  // namespace thinbench
