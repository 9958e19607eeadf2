// Instruction sets (ISAs) that kernels are compiled for, which of them this machine supports, and a
// cap for tests. All functions are thread-safe.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "thinbench/containers.hpp"
#include "thinbench/export.h"

namespace thinbench {

/// A named set of processor features. `avx512` is F, CD, DQ, BW and VL; `avx512icl` adds VBMI,
/// VBMI2, GFNI, VNNI, BITALG and VPOPCNTDQ (Ice Lake and later, Zen 4 and later). On x86-64 each of
/// these sets contains the ones before it. On AArch64 `baseline` is Advanced SIMD (NEON), which
/// every processor has; `neon_sha3` adds FEAT_SHA3 (Apple M1, Neoverse V1 and N2, and later).
enum class Isa : std::uint8_t { baseline, sse42, avx2, avx512, avx512icl, neon_sha3 };

/// Every ISA that this library's kernels are compiled for: those of its architecture, in the order
/// of the enumeration, `baseline` first; `baseline` alone without SIMD.
[[nodiscard]] THINBENCH_API std::span<const Isa> all_isas();

/// The environment variable that caps the available ISAs: with `THINBENCH_MAX_ISA=avx2` only avx2
/// and the ISAs it contains are available. Read once, on first use; an unknown name is then
/// reported in one line on standard error, and there is no cap.
inline constexpr const char* kIsaCapVariable = "THINBENCH_MAX_ISA";

/// "baseline", "sse4.2", "avx2", "avx512", "avx512icl", "neon-sha3". All functions that take an Isa
/// throw std::invalid_argument for a value outside the enumeration.
[[nodiscard]] THINBENCH_API std::string_view isa_name(Isa isa);
/// One of all_isas().
[[nodiscard]] THINBENCH_API std::optional<Isa> isa_from_name(std::string_view name);

/// Whether processor and operating system support every feature of the set, regardless of the cap.
[[nodiscard]] THINBENCH_API bool cpu_supports(Isa isa);

/// The features of the set that processor or operating system lack, as "avx2, bmi2"; empty if none.
[[nodiscard]] THINBENCH_API std::string missing_features(Isa isa);

/// The ISA in the environment variable, or nullopt if it is unset or empty. Throws
/// std::invalid_argument for an unknown name.
[[nodiscard]] THINBENCH_API std::optional<Isa> isa_cap();

/// Whether kernels are compiled for the set, the processor supports it and the cap contains it.
[[nodiscard]] THINBENCH_API bool isa_available(Isa isa);

/// The last of all_isas() that is available.
[[nodiscard]] THINBENCH_API Isa best_isa();

}  // namespace thinbench
