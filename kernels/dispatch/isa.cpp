#include "thinbench/isa.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace thinbench {
namespace {

/// A set of processor features.
using Features = std::uint32_t;

constexpr Features kSse42 = 1U << 0;
constexpr Features kPopcnt = 1U << 1;
constexpr Features kAvx2 = 1U << 2;
constexpr Features kBmi = 1U << 3;
constexpr Features kBmi2 = 1U << 4;
constexpr Features kAvx512F = 1U << 5;
constexpr Features kAvx512Cd = 1U << 6;
constexpr Features kAvx512Dq = 1U << 7;
constexpr Features kAvx512Bw = 1U << 8;
constexpr Features kAvx512Vl = 1U << 9;
constexpr Features kAvx512Vbmi = 1U << 10;
constexpr Features kAvx512Vbmi2 = 1U << 11;
constexpr Features kAvx512Vnni = 1U << 12;
constexpr Features kAvx512Bitalg = 1U << 13;
constexpr Features kAvx512Vpopcntdq = 1U << 14;
constexpr Features kGfni = 1U << 15;

// __builtin_cpu_supports also checks that the operating system saves AVX and AVX-512 registers.
Features detect_features() {
  __builtin_cpu_init();
  Features found = 0;
  const auto add = [&found](bool supported, Features feature) { found |= supported ? feature : 0; };
  add(__builtin_cpu_supports("sse4.2"), kSse42);
  add(__builtin_cpu_supports("popcnt"), kPopcnt);
  add(__builtin_cpu_supports("avx2"), kAvx2);
  add(__builtin_cpu_supports("bmi"), kBmi);
  add(__builtin_cpu_supports("bmi2"), kBmi2);
  add(__builtin_cpu_supports("avx512f"), kAvx512F);
  add(__builtin_cpu_supports("avx512cd"), kAvx512Cd);
  add(__builtin_cpu_supports("avx512dq"), kAvx512Dq);
  add(__builtin_cpu_supports("avx512bw"), kAvx512Bw);
  add(__builtin_cpu_supports("avx512vl"), kAvx512Vl);
  add(__builtin_cpu_supports("avx512vbmi"), kAvx512Vbmi);
  add(__builtin_cpu_supports("avx512vbmi2"), kAvx512Vbmi2);
  add(__builtin_cpu_supports("avx512vnni"), kAvx512Vnni);
  add(__builtin_cpu_supports("avx512bitalg"), kAvx512Bitalg);
  add(__builtin_cpu_supports("avx512vpopcntdq"), kAvx512Vpopcntdq);
  add(__builtin_cpu_supports("gfni"), kGfni);
  return found;
}

constexpr bool contains(Features set, Features subset) {
  return (subset & ~set) == 0;
}

struct IsaInfo {
  std::string_view name;
  Features features;
};

constexpr Features kSse42Isa = kSse42 | kPopcnt;
constexpr Features kAvx2Isa = kSse42Isa | kAvx2 | kBmi | kBmi2;
constexpr Features kAvx512Isa = kAvx2Isa | kAvx512F | kAvx512Cd | kAvx512Dq | kAvx512Bw | kAvx512Vl;
constexpr Features kAvx512IclIsa = kAvx512Isa | kAvx512Vbmi | kAvx512Vbmi2 | kAvx512Vnni |
                                   kAvx512Bitalg | kAvx512Vpopcntdq | kGfni;

/// In the order of the enumeration.
constexpr std::array<IsaInfo, kAllIsas.size()> kInfos = {{{"baseline", 0},
                                                          {"sse4.2", kSse42Isa},
                                                          {"avx2", kAvx2Isa},
                                                          {"avx512", kAvx512Isa},
                                                          {"avx512icl", kAvx512IclIsa}}};

std::string names() {
  std::string text;
  for (const IsaInfo& info : kInfos) text.append(text.empty() ? "" : ", ").append(info.name);
  return text;
}

const IsaInfo& info_of(Isa isa) {
  const auto number = static_cast<std::size_t>(isa);
  if (number < kInfos.size()) return kInfos[number];
  throw std::invalid_argument("isa: expected one of " + names() + ", got number " +
                              std::to_string(number));
}

std::optional<Isa> read_cap() {
  const char* text = std::getenv(kIsaCapVariable);
  if (text == nullptr || *text == '\0') return std::nullopt;
  if (const auto isa = isa_from_name(text)) return isa;
  throw std::invalid_argument(std::string(kIsaCapVariable) + ": expected one of " + names() +
                              ", got '" + text + "'");
}

}  // namespace

std::string_view isa_name(Isa isa) {
  return info_of(isa).name;
}

std::optional<Isa> isa_from_name(std::string_view name) {
  for (const Isa isa : kAllIsas) {
    if (isa_name(isa) == name) return isa;
  }
  return std::nullopt;
}

bool cpu_supports(Isa isa) {
  static const Features available = detect_features();
  return contains(available, info_of(isa).features);
}

std::optional<Isa> isa_cap() {
  static const std::optional<Isa> cap = read_cap();
  return cap;
}

bool isa_available(Isa isa) {
  const std::optional<Isa> cap = isa_cap();
  const bool allowed = !cap || contains(info_of(*cap).features, info_of(isa).features);
  return allowed && cpu_supports(isa);
}

Isa best_isa() {
  Isa best = Isa::baseline;
  for (const Isa isa : kAllIsas) {
    if (isa_available(isa)) best = isa;
  }
  return best;
}

}  // namespace thinbench
