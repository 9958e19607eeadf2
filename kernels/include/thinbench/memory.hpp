// Memory that the library keeps between calls.
#pragma once

#include "thinbench/export.h"

namespace thinbench {

/// Frees the memory that the calling thread keeps for its next calls: at most 8 MiB in 32 blocks,
/// from states and images that it has destroyed. A thread that ends frees it, too. Also frees as
/// much for each worker that calls with several threads have used at once, but for those at work in
/// another call now. After fork(), the child goes on with a copy of all this. Thread-safe.
THINBENCH_API void release_memory() noexcept;

}  // namespace thinbench
