// What a reader must know about a machine and a build to judge or to repeat measurements.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace thinbench {

/// As lscpu names them; "unknown" where it does not.
struct CpuFacts {
  std::string vendor = "unknown";  // "intel", "amd", else the name in lower case
  std::string family = "unknown";
  std::string model = "unknown";
  std::string stepping = "unknown";
  std::string name = "unknown";
  std::vector<std::string> flags = {};  // sorted
};

/// From the output of `lscpu --json`.
[[nodiscard]] CpuFacts cpu_facts_from(const std::string& lscpu);

/// [{"level", "type", "size_kib"}], nearest first, from the output of `lscpu --caches --bytes
/// --json`.
[[nodiscard]] nlohmann::json caches_from(const std::string& lscpu);

/// "vendor-family-model-stepping-hash". Equal for equal processors with equal flags and programs
/// built by the same compiler with the same flags.
[[nodiscard]] std::string machine_fingerprint(const CpuFacts& cpu);

/// The same for this machine.
[[nodiscard]] std::string machine_fingerprint();

/// Compiler, version, flags and build type.
[[nodiscard]] nlohmann::json compiler_json();

/// Processor, memory, system, compiler, libraries and instruction sets. Throws
/// std::invalid_argument where the cap on the instruction set is malformed.
[[nodiscard]] nlohmann::json machine_json();

}  // namespace thinbench
