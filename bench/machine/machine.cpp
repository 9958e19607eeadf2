#include "machine/machine.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <thread>

#include <sys/utsname.h>

#include "thinbench/isa.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

/// FNV-1a with 32 bits: short, and the same everywhere.
std::uint32_t fnv1a(const std::string& text) {
  std::uint32_t hash = 0x811C9DC5;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193;
  return hash;
}

std::string build_text() {
  return std::string(THINBENCH_COMPILER_ID) + " " + THINBENCH_COMPILER_VERSION + " " +
         THINBENCH_COMPILER_FLAGS;
}

/// A number where the text is one.
Json number_or_text(const std::string& text) {
  long number = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  if (result.ec == std::errc() && result.ptr == end) return number;
  return text;
}

Json cpu_json(const CpuFacts& cpu) {
  return {{"vendor", cpu.vendor},
          {"family", number_or_text(cpu.family)},
          {"model", number_or_text(cpu.model)},
          {"stepping", number_or_text(cpu.stepping)},
          {"name", cpu.name},
          {"flags", cpu.flags}};
}

Json compiler_json() {
  return {{"id", THINBENCH_COMPILER_ID},
          {"version", THINBENCH_COMPILER_VERSION},
          {"flags", THINBENCH_COMPILER_FLAGS},
          {"build_type", THINBENCH_BUILD_TYPE}};
}

Json libraries_json() {
  return {{"xsimd", THINBENCH_XSIMD_VERSION},
          {"tbb", THINBENCH_TBB_VERSION},
          {"opencv", THINBENCH_OPENCV_VERSION},
          {"benchmark", THINBENCH_BENCHMARK_VERSION}};
}

std::string kernel_text() {
  utsname names{};
  if (uname(&names) != 0) return "unknown";
  return std::string(names.sysname) + " " + names.release;
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return {text.data(), length};
}

/// Null where nothing caps it.
Json isa_cap_json() {
  const std::optional<Isa> cap = isa_cap();
  return cap ? Json(isa_name(*cap)) : Json();
}

Json available_isas() {
  Json names = Json::array();
  for (const Isa isa : kAllIsas) {
    if (isa_available(isa)) names.push_back(isa_name(isa));
  }
  return names;
}

}  // namespace

std::string machine_fingerprint(const CpuFacts& cpu) {
  std::string hashed;
  for (const std::string& flag : cpu.flags) hashed += flag + " ";
  std::array<char, 9> hash{};
  std::snprintf(hash.data(), hash.size(), "%08x", fnv1a(hashed + build_text()));
  return cpu.vendor + "-" + cpu.family + "-" + cpu.model + "-" + cpu.stepping + "-" + hash.data();
}

Json machine_json(const std::string& commit, const Json& options) {
  const CpuFacts cpu = read_cpu();
  return {{"schema", 1},
          {"fingerprint", machine_fingerprint(cpu)},
          {"cpu", cpu_json(cpu)},
          {"cores", std::thread::hardware_concurrency()},
          {"caches", read_caches()},
          {"memory_gib", read_memory_gib()},
          {"kernel", kernel_text()},
          {"os", read_os()},
          {"compiler", compiler_json()},
          {"libraries", libraries_json()},
          {"commit", commit},
          {"date", utc_now()},
          {"options", options},
          {"isa_available", available_isas()},
          {"isa_cap", isa_cap_json()}};
}

}  // namespace thinbench
