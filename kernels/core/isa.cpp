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

using detail::Features;
using detail::features_of;
using detail::kIsas;

namespace {

/// In the order of the enumeration.
constexpr auto kNames = std::to_array<std::string_view>(
    {"baseline", "sse4.2", "avx2", "avx512", "avx512icl", "neon-sha3"});

std::string names() {
  std::string text;
  for (const Isa isa : kIsas) text.append(text.empty() ? "" : ", ").append(isa_name(isa));
  return text;
}

/// The ISA itself; throws outside the enumeration.
Isa checked(Isa isa) {
  const auto number = static_cast<std::size_t>(isa);
  if (number < kNames.size()) return isa;
  throw std::invalid_argument("isa: expected one of " + names() + ", got number " +
                              std::to_string(number));
}

Features missing(Isa isa) {
  static const Features available = detail::detect_features();
  return features_of(checked(isa)) & ~available;
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

std::string_view isa_name(Isa isa) {
  return kNames[static_cast<std::size_t>(checked(isa))];
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
  const Features wanted = features_of(checked(isa));
  const std::optional<Isa> cap = cap_in_use();
  const bool allowed = !cap || detail::has(*cap, wanted);
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
