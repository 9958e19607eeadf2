#include "machine/machine.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <thread>

#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include "thinbench/isa.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

/// What a command prints; empty where it cannot be run.
std::string output_of(const char* command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command, "r"), &pclose);
  std::string text;
  std::array<char, 4096> bytes{};
  while (pipe != nullptr) {
    const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), pipe.get());
    if (count == 0) break;
    text.append(bytes.data(), count);
  }
  return text;
}

std::string short_vendor(std::string vendor) {
  if (vendor == "GenuineIntel") return "intel";
  if (vendor == "AuthenticAMD") return "amd";
  std::transform(vendor.begin(), vendor.end(), vendor.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return vendor;
}

std::vector<std::string> sorted_words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words(std::istream_iterator<std::string>(stream), {});
  std::sort(words.begin(), words.end());
  return words;
}

/// The full name of the operating system.
std::string os_text() {
  std::ifstream file("/etc/os-release");
  const std::string key = "PRETTY_NAME=\"";
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(key)) return line.substr(key.size(), line.size() - key.size() - 1);
  }
  return "unknown";
}

/// Installed memory with one decimal.
double memory_gib() {
  const double bytes =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::round(bytes / (1 << 30) * 10) / 10;
}

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
  std::array<char, 32> text{};
  const char* format = "%Y-%m-%dT%H:%M:%SZ";
  return {text.data(), std::strftime(text.data(), text.size(), format, std::gmtime(&now))};
}

/// Null where nothing caps it.
Json isa_cap_json() {
  const std::optional<Isa> cap = isa_cap();
  return cap ? Json(isa_name(*cap)) : Json();
}

Json available_isas() {
  Json names = Json::array();
  for (const Isa isa : all_isas()) {
    if (isa_available(isa)) names.push_back(isa_name(isa));
  }
  return names;
}

}  // namespace

CpuFacts cpu_facts_from(const std::string& lscpu) {
  CpuFacts cpu;
  const Json parsed = Json::parse(lscpu, nullptr, false);
  if (!parsed.is_object()) return cpu;
  for (const Json& line : parsed.value("lscpu", Json::array())) {
    const std::string field = line.value("field", "");
    const std::string data = line.value("data", "");
    if (field == "Vendor ID:") cpu.vendor = short_vendor(data);
    if (field == "CPU family:") cpu.family = data;
    if (field == "Model:") cpu.model = data;
    if (field == "Stepping:") cpu.stepping = data;
    if (field == "Model name:") cpu.name = data;
    if (field == "Flags:") cpu.flags = sorted_words(data);
  }
  return cpu;
}

Json caches_from(const std::string& lscpu) {
  Json caches = Json::array();
  const Json parsed = Json::parse(lscpu, nullptr, false);
  if (!parsed.is_object()) return caches;
  for (const Json& cache : parsed.value("caches", Json::array())) {
    const long bytes = std::stol(cache.value("one-size", "0"));
    caches.push_back(
        {{"level", cache.at("level")}, {"type", cache.at("type")}, {"size_kib", bytes / 1024}});
  }
  return caches;
}

std::string machine_fingerprint(const CpuFacts& cpu) {
  const std::string hashed = fmt::format("{} {}", fmt::join(cpu.flags, " "), build_text());
  return fmt::format("{}-{}-{}-{}-{:08x}", cpu.vendor, cpu.family, cpu.model, cpu.stepping,
                     fnv1a(hashed));
}

std::string machine_fingerprint() {
  return machine_fingerprint(cpu_facts_from(output_of("lscpu --json 2>/dev/null")));
}

Json compiler_json() {
  return {{"id", THINBENCH_COMPILER_ID},
          {"version", THINBENCH_COMPILER_VERSION},
          {"flags", THINBENCH_COMPILER_FLAGS},
          {"build_type", THINBENCH_BUILD_TYPE}};
}

Json machine_json() {
  const CpuFacts cpu = cpu_facts_from(output_of("lscpu --json 2>/dev/null"));
  return {{"schema", 1},
          {"fingerprint", machine_fingerprint(cpu)},
          {"cpu", cpu_json(cpu)},
          {"cores", std::thread::hardware_concurrency()},
          {"caches", caches_from(output_of("lscpu --caches --bytes --json 2>/dev/null"))},
          {"memory_gib", memory_gib()},
          {"kernel", kernel_text()},
          {"os", os_text()},
          {"compiler", compiler_json()},
          {"libraries", libraries_json()},
          {"date", utc_now()},
          {"isa_available", available_isas()},
          {"isa_cap", isa_cap_json()}};
}

}  // namespace thinbench
