#include "thinbench/isa.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "dispatch/features.hpp"

namespace thinbench {
namespace {

using detail::Features;

struct IsaInfo {
  std::string_view name;
  Features features;
};

constexpr Features kSse42Features = Features::sse4_2 | Features::popcnt;
constexpr Features kAvx2Features = kSse42Features | Features::avx2 | Features::bmi | Features::bmi2;
constexpr Features kAvx512Features = kAvx2Features | Features::avx512f | Features::avx512cd |
                                     Features::avx512dq | Features::avx512bw | Features::avx512vl;
constexpr Features kAvx512IclFeatures =
    kAvx512Features | Features::avx512vbmi | Features::avx512vbmi2 | Features::avx512vnni |
    Features::avx512bitalg | Features::avx512vpopcntdq | Features::gfni;

/// In the order of the enumeration.
constexpr std::array<IsaInfo, kAllIsas.size()> kInfos = {{{"baseline", Features::none},
                                                          {"sse4.2", kSse42Features},
                                                          {"avx2", kAvx2Features},
                                                          {"avx512", kAvx512Features},
                                                          {"avx512icl", kAvx512IclFeatures}}};

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
  static const Features available = detail::detect_features();
  return detail::contains(available, info_of(isa).features);
}

std::optional<Isa> isa_cap() {
  static const std::optional<Isa> cap = read_cap();
  return cap;
}

bool isa_available(Isa isa) {
  const std::optional<Isa> cap = isa_cap();
  const bool allowed = !cap || detail::contains(info_of(*cap).features, info_of(isa).features);
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
