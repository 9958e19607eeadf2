// What a reader must know about a build to judge or to repeat measurements.
#pragma once

#include <nlohmann/json.hpp>

namespace thinbench {

/// Compiler, version, flags and build type.
[[nodiscard]] nlohmann::json compiler_json();

/// Compiler, libraries and instruction sets. Throws std::invalid_argument where the cap on the
/// instruction set is malformed.
[[nodiscard]] nlohmann::json build_facts();

}  // namespace thinbench
