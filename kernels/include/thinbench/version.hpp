// The version of the library. For the preprocessor: THINBENCH_VERSION_MAJOR, _MINOR and _PATCH.
#pragma once

#include <string_view>

#include "thinbench/export.h"

namespace thinbench {

inline constexpr std::string_view kVersion = "1.0.0";

}  // namespace thinbench
