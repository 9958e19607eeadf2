#include "machine/facts.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

namespace thinbench {
namespace {

namespace fs = std::filesystem;
using Fields = std::map<std::string, std::string>;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\"");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\"") - first + 1);
}

/// Lines of the kind "name : value" up to the first empty one; empty where there is no such file.
Fields read_fields(const fs::path& file, char separator) {
  std::ifstream stream(file);
  Fields fields;
  for (std::string line; std::getline(stream, line) && !line.empty();) {
    const auto middle = line.find(separator);
    if (middle == std::string::npos) continue;
    fields.emplace(trimmed(line.substr(0, middle)), trimmed(line.substr(middle + 1)));
  }
  return fields;
}

std::string value_or_unknown(const Fields& fields, const std::string& name) {
  const auto found = fields.find(name);
  return found == fields.end() || found->second.empty() ? "unknown" : found->second;
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
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  std::sort(words.begin(), words.end());
  return words;
}

std::string first_line(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return trimmed(line);
}

std::optional<long> leading_number(const std::string& text) {
  long number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

/// "48K" or "2M" as the kernel writes it.
std::optional<long> size_kib(const std::string& text) {
  const auto number = leading_number(text);
  if (!number) return std::nullopt;
  return text.back() == 'M' ? *number * 1024 : *number;
}

}  // namespace

CpuFacts read_cpu(const fs::path& root) {
  const Fields fields = read_fields(root / "proc/cpuinfo", ':');
  const auto flags = fields.find("flags");
  return {short_vendor(value_or_unknown(fields, "vendor_id")),
          value_or_unknown(fields, "cpu family"),
          value_or_unknown(fields, "model"),
          value_or_unknown(fields, "stepping"),
          value_or_unknown(fields, "model name"),
          flags == fields.end() ? std::vector<std::string>() : sorted_words(flags->second)};
}

nlohmann::json read_caches(const fs::path& root) {
  auto caches = nlohmann::json::array();
  for (int index = 0;; ++index) {
    const fs::path folder =
        root / "sys/devices/system/cpu/cpu0/cache" / ("index" + std::to_string(index));
    const auto level = leading_number(first_line(folder / "level"));
    if (!level) return caches;
    const auto size = size_kib(first_line(folder / "size"));
    if (!size) continue;
    caches.push_back(
        {{"level", *level}, {"type", first_line(folder / "type")}, {"size_kib", *size}});
  }
}

nlohmann::json read_memory_gib(const fs::path& root) {
  const auto kib =
      leading_number(value_or_unknown(read_fields(root / "proc/meminfo", ':'), "MemTotal"));
  if (!kib) return "unknown";
  return std::round(static_cast<double>(*kib) / (1024.0 * 1024.0) * 10.0) / 10.0;
}

std::string read_os(const fs::path& root) {
  return value_or_unknown(read_fields(root / "etc/os-release", '='), "PRETTY_NAME");
}

}  // namespace thinbench
