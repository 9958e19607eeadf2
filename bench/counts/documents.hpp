// Counts and limits as JSON files and as tables of text.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "counts/limits.hpp"
#include "counts/row_counts.hpp"

namespace thinbench {

inline constexpr int kCountsSchema = 3;
inline constexpr int kLimitsSchema = 2;
inline constexpr const char* kInstructionsKind = "instructions";

/// What must be equal for counts to be comparable: compiler and flags, the C library and the
/// highest ISA of the processor, which its functions choose by.
[[nodiscard]] nlohmann::ordered_json build_json();

/// Flat rows, so that any tool makes CSV of them.
[[nodiscard]] nlohmann::ordered_json counts_json(const TimedInput& input, const RowCounts& counts,
                                                 std::uint64_t max_steps);
[[nodiscard]] nlohmann::ordered_json limits_json(const TimedInput& input, const Limits& limits);

[[nodiscard]] std::string counts_table(const RowCounts& counts);
[[nodiscard]] std::string limits_table(const Limits& limits);

}  // namespace thinbench
