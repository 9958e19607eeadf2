// The version of the library. For the preprocessor: THINBENCH_VERSION_MAJOR, _MINOR and _PATCH.
#pragma once

#include <string_view>

#include "thinbench/export.h"

#define THINBENCH_JOINED(major, minor, patch) #major "." #minor "." #patch
#define THINBENCH_EXPANDED(major, minor, patch) THINBENCH_JOINED(major, minor, patch)

namespace thinbench {

inline constexpr std::string_view kVersion =
    THINBENCH_EXPANDED(THINBENCH_VERSION_MAJOR, THINBENCH_VERSION_MINOR, THINBENCH_VERSION_PATCH);

}  // namespace thinbench

#undef THINBENCH_EXPANDED
#undef THINBENCH_JOINED
