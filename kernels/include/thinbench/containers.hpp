// Standard containers and structs that later versions may extend cross the C++ interface, so a
// program and the library must mean the same by them.
#pragma once

#include "thinbench/export.h"

namespace thinbench::detail {

// The library defines one of the two, whose names change with each minor version. A program that
// was compiled with headers of another one, or with other containers, does not link or start.
#ifdef _GLIBCXX_DEBUG
THINBENCH_API extern const bool kInterface1x0Debug;
[[gnu::used]] static const bool* const kInterfacesAgree = &kInterface1x0Debug;
#else
THINBENCH_API extern const bool kInterface1x0;
[[gnu::used]] static const bool* const kInterfacesAgree = &kInterface1x0;
#endif

}  // namespace thinbench::detail
