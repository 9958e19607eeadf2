// What the operating system tells about this machine. Whatever it does not tell is "unknown".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace thinbench {

/// As in /proc/cpuinfo, for the first processor.
struct CpuFacts {
  std::string vendor = "unknown";  // "intel", "amd", else the name in lower case
  std::string family = "unknown";
  std::string model = "unknown";
  std::string stepping = "unknown";
  std::string name = "unknown";
  std::vector<std::string> flags;  // sorted
};

/// Files are looked up below `root`, which holds proc, sys and etc.
[[nodiscard]] CpuFacts read_cpu(const std::filesystem::path& root = "/");

/// [{"level", "type", "size_kib"}] of the first processor, nearest first; empty where unknown.
[[nodiscard]] nlohmann::json read_caches(const std::filesystem::path& root = "/");

/// Installed memory with one decimal, or "unknown".
[[nodiscard]] nlohmann::json read_memory_gib(const std::filesystem::path& root = "/");

/// The full name of the operating system.
[[nodiscard]] std::string read_os(const std::filesystem::path& root = "/");

}  // namespace thinbench
