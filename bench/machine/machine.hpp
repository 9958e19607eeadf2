// What a reader must know about a machine and a build to judge or to repeat measurements.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "machine/facts.hpp"

namespace thinbench {

/// "vendor-family-model-stepping-hash". Equal for equal processors with equal flags and programs
/// built by the same compiler with the same flags.
[[nodiscard]] std::string machine_fingerprint(const CpuFacts& cpu);

/// Processor, memory, system, compiler, libraries and instruction sets, with the commit and the
/// options of the run that they are told for. Throws std::invalid_argument where the cap on the
/// instruction set is malformed.
[[nodiscard]] nlohmann::json machine_json(const std::string& commit, const nlohmann::json& options);

}  // namespace thinbench
