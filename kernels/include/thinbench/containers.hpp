// Standard containers cross the C++ interface, so a program and the library must mean the same by
// them.
#pragma once

#include "thinbench/export.h"

namespace thinbench::detail {

// The library defines one of the two. In a program that is compiled otherwise, linking stops at the
// other.
#ifdef _GLIBCXX_DEBUG
THINBENCH_API extern const bool kLibraryHasDebugContainers;
[[gnu::used]] static const bool* const kContainersAgree = &kLibraryHasDebugContainers;
#else
THINBENCH_API extern const bool kLibraryHasUsualContainers;
[[gnu::used]] static const bool* const kContainersAgree = &kLibraryHasUsualContainers;
#endif

}  // namespace thinbench::detail
