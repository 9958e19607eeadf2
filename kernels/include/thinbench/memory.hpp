// Memory that the library keeps between calls.
#pragma once

#include "thinbench/export.h"

namespace thinbench {

/// Frees the memory that the calling thread keeps for its next calls: at most 8 MiB in 32 blocks,
/// from states and images that it has destroyed. A thread that ends frees it, too. After fork(),
/// the child goes on with a copy of that of the forking thread. Thread-safe.
THINBENCH_API void release_memory() noexcept;

}  // namespace thinbench
