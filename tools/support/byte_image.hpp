// The library's own image owner, under a short name: inputs and outputs of benchmarks and tests.
#pragma once

#include "core/byte_image.hpp"

namespace thinbench {

using detail::ByteImage;
using detail::copy_of;
using detail::equal;

}  // namespace thinbench
