// Instruction-set levels: what each needs, what this machine has, and the cap that tests use.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace thinbench {

/// Each level contains the ones before it. `kAvx512` is the F, CD, DQ, BW, VL set; `kAvx512Icl`
/// adds VBMI, VBMI2, GFNI, VNNI, BITALG and VPOPCNTDQ (Ice Lake and later, Zen 4 and later).
enum class Isa : std::uint8_t { baseline, sse42, avx2, avx512, avx512icl };

inline constexpr std::array kAllIsas = {Isa::baseline, Isa::sse42, Isa::avx2, Isa::avx512,
                                        Isa::avx512icl};

/// Caps the level on any machine, e.g. `THINBENCH_MAX_ISA=avx2`.
inline constexpr const char* kIsaCapVariable = "THINBENCH_MAX_ISA";

[[nodiscard]] std::string_view isa_name(Isa isa);
[[nodiscard]] std::optional<Isa> isa_from_name(std::string_view name);

/// What the processor and the operating system offer, whatever the cap says.
[[nodiscard]] bool cpu_supports(Isa isa);

/// The cap from the environment; the highest level where it is unset or empty. Throws
/// std::invalid_argument for a name that is no level.
[[nodiscard]] Isa isa_cap();

/// True where the processor supports the level and the cap allows it.
[[nodiscard]] bool isa_available(Isa isa);

/// The highest level that is available.
[[nodiscard]] Isa best_isa();

}  // namespace thinbench
