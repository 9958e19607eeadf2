#include "dispatch/isa.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace thinbench {
namespace {

constexpr std::array<std::string_view, kAllIsas.size()> kNames = {"baseline", "sse4.2", "avx2",
                                                                  "avx512", "avx512icl"};

bool has_avx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512vl");
}

bool has_icelake_extensions() {
  return __builtin_cpu_supports("avx512vbmi") && __builtin_cpu_supports("avx512vbmi2") &&
         __builtin_cpu_supports("avx512vnni") && __builtin_cpu_supports("avx512bitalg") &&
         __builtin_cpu_supports("avx512vpopcntdq") && __builtin_cpu_supports("gfni");
}

bool has_avx2() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
         __builtin_cpu_supports("bmi2");
}

}  // namespace

std::string_view isa_name(Isa isa) {
  return kNames.at(static_cast<std::size_t>(isa));
}

std::optional<Isa> isa_from_name(std::string_view name) {
  for (const Isa isa : kAllIsas) {
    if (isa_name(isa) == name) return isa;
  }
  return std::nullopt;
}

bool cpu_supports(Isa isa) {
  __builtin_cpu_init();
  switch (isa) {
    case Isa::baseline:
      return true;
    case Isa::sse42:
      return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt");
    case Isa::avx2:
      return cpu_supports(Isa::sse42) && has_avx2();
    case Isa::avx512:
      return cpu_supports(Isa::avx2) && has_avx512();
    case Isa::avx512icl:
      return cpu_supports(Isa::avx512) && has_icelake_extensions();
  }
  return false;
}

Isa isa_cap() {
  const char* text = std::getenv(kIsaCapVariable);
  if (text == nullptr || *text == '\0') return kAllIsas.back();
  if (const auto isa = isa_from_name(text)) return *isa;
  throw std::invalid_argument(std::string(kIsaCapVariable) + "=" + text +
                              " is no level; use baseline, sse4.2, avx2, avx512 or avx512icl");
}

bool isa_available(Isa isa) {
  return isa <= isa_cap() && cpu_supports(isa);
}

Isa best_isa() {
  Isa best = Isa::baseline;
  for (const Isa isa : kAllIsas) {
    if (isa_available(isa)) best = isa;
  }
  return best;
}

}  // namespace thinbench
