// Instruction sets (ISAs) that kernels are compiled for, which of them this machine supports, and a
// cap for tests. All functions are thread-safe.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "thinbench/export.h"

namespace thinbench {

/// A named set of processor features. `avx512` is F, CD, DQ, BW and VL; `avx512icl` adds VBMI,
/// VBMI2, GFNI, VNNI, BITALG and VPOPCNTDQ (Ice Lake and later, Zen 4 and later). On x86-64 each of
/// these sets contains the ones before it.
enum class Isa : std::uint8_t { baseline, sse42, avx2, avx512, avx512icl };

/// Every ISA that kernels are compiled for.
inline constexpr std::array kAllIsas = {Isa::baseline, Isa::sse42, Isa::avx2, Isa::avx512,
                                        Isa::avx512icl};

/// The environment variable that caps the available ISAs: with `THINBENCH_MAX_ISA=avx2` only avx2
/// and the ISAs it contains are available. Read once, on first use.
inline constexpr const char* kIsaCapVariable = "THINBENCH_MAX_ISA";

/// "baseline", "sse4.2", "avx2", "avx512", "avx512icl". All functions that take an Isa throw
/// std::invalid_argument for a value outside the enumeration.
[[nodiscard]] THINBENCH_API std::string_view isa_name(Isa isa);
[[nodiscard]] THINBENCH_API std::optional<Isa> isa_from_name(std::string_view name);

/// Whether processor and operating system support every feature of the set, regardless of the cap.
[[nodiscard]] THINBENCH_API bool cpu_supports(Isa isa);

/// The ISA in the environment variable, or nullopt if it is unset or empty. Throws
/// std::invalid_argument for an unknown name.
[[nodiscard]] THINBENCH_API std::optional<Isa> isa_cap();

/// Whether the processor supports the set and the cap contains it. Throws as isa_cap does.
[[nodiscard]] THINBENCH_API bool isa_available(Isa isa);

/// The last of kAllIsas that is available. Throws as isa_cap does.
[[nodiscard]] THINBENCH_API Isa best_isa();

}  // namespace thinbench
