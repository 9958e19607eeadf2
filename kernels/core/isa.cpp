#include "thinbench/isa.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "core/features.hpp"
#include "core/isas.hpp"

namespace thinbench {

using detail::feature;
using detail::Features;
using detail::kIsas;

namespace {

struct IsaInfo {
  std::string_view name;
  Features features;
};

constexpr Features kSse42 = feature("sse4.2") | feature("popcnt");
constexpr Features kAvx2 = kSse42 | feature("avx2") | feature("bmi") | feature("bmi2");
constexpr Features kAvx512 = kAvx2 | feature("avx512f") | feature("avx512cd") |
                             feature("avx512dq") | feature("avx512bw") | feature("avx512vl");
constexpr Features kAvx512Icl = kAvx512 | feature("avx512vbmi") | feature("avx512vbmi2") |
                                feature("avx512vnni") | feature("avx512bitalg") |
                                feature("avx512vpopcntdq") | feature("gfni");

/// In the order of the enumeration.
constexpr auto kInfos = std::to_array<IsaInfo>({{"baseline", 0},
                                                {"sse4.2", kSse42},
                                                {"avx2", kAvx2},
                                                {"avx512", kAvx512},
                                                {"avx512icl", kAvx512Icl},
                                                {"neon-sha3", feature("sha3")}});

std::string names() {
  std::string text;
  for (const Isa isa : kIsas) text.append(text.empty() ? "" : ", ").append(isa_name(isa));
  return text;
}

const IsaInfo& info_of(Isa isa) {
  const auto number = static_cast<std::size_t>(isa);
  if (number < kInfos.size()) return kInfos[number];
  throw std::invalid_argument("isa: expected one of " + names() + ", got number " +
                              std::to_string(number));
}

Features missing(Isa isa) {
  static const Features available = detail::detect_features();
  return info_of(isa).features & ~available;
}

/// Throws for an unknown name.
std::optional<Isa> read_cap() {
  const char* text = std::getenv(kIsaCapVariable);
  if (text == nullptr || *text == '\0') return std::nullopt;
  if (const auto isa = isa_from_name(text)) return isa;
  throw std::invalid_argument(std::string(kIsaCapVariable) + ": expected one of " + names() +
                              ", got '" + text + "'");
}

/// An unknown name is reported once, then there is no cap.
std::optional<Isa> cap_or_none() {
  try {
    return read_cap();
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "thinbench: %s; there is no cap\n", error.what());
    return std::nullopt;
  }
}

/// Read once.
std::optional<Isa> cap_in_use() {
  static const std::optional<Isa> cap = cap_or_none();
  return cap;
}

}  // namespace

namespace detail {

Features features_of(Isa isa) {
  return info_of(isa).features;
}

std::vector<Isa> isas_with(Features used) {
  std::vector<Isa> isas;
  Features before = 0;
  for (const Isa isa : kIsas) {
    const Features added = features_of(isa) & ~before;
    if (isas.empty() || (added & used) != 0) isas.push_back(isa);
    before |= features_of(isa);
  }
  return isas;
}

}  // namespace detail

std::string_view isa_name(Isa isa) {
  return info_of(isa).name;
}

std::optional<Isa> isa_from_name(std::string_view name) {
  for (const Isa isa : kIsas) {
    if (isa_name(isa) == name) return isa;
  }
  return std::nullopt;
}

std::span<const Isa> all_isas() {
  return kIsas;
}

bool cpu_supports(Isa isa) {
  return missing(isa) == 0;
}

std::string missing_features(Isa isa) {
  const Features lacking = missing(isa);
  std::string names;
  if (lacking == 0) return names;
  for (std::size_t i = 0; i < detail::kFeatureNames.size(); ++i) {
    if ((lacking >> i & 1) == 0) continue;
    names.append(names.empty() ? "" : ", ").append(detail::kFeatureNames[i]);
  }
  return names;
}

std::optional<Isa> isa_cap() {
  static const std::optional<Isa> cap = read_cap();
  return cap;
}

bool isa_available(Isa isa) {
  const auto& wanted = info_of(isa);  // throws outside the enumeration
  const std::optional<Isa> cap = cap_in_use();
  const bool allowed = !cap || (wanted.features & ~info_of(*cap).features) == 0;
  const bool compiled = std::find(kIsas.begin(), kIsas.end(), isa) != kIsas.end();
  return allowed && compiled && cpu_supports(isa);
}

Isa best_isa() {
  Isa best = Isa::baseline;
  for (const Isa isa : kIsas) {
    if (isa_available(isa)) best = isa;
  }
  return best;
}

}  // namespace thinbench
