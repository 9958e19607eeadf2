// The version of the library.
#pragma once

#include <string_view>

namespace thinbench {

inline constexpr int kVersionMajor = 1;
inline constexpr int kVersionMinor = 0;
inline constexpr int kVersionPatch = 0;
inline constexpr std::string_view kVersion = "1.0.0";

}  // namespace thinbench
