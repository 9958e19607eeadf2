// Counts as a JSON file and as a table of text.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "counts/row_counts.hpp"

namespace thinbench {

inline constexpr int kCountsSchema = 3;
inline constexpr const char* kInstructionsKind = "instructions";

/// What must be equal for counts to be comparable: compiler and flags, the C library and the
/// highest ISA of the processor, which its functions choose by.
[[nodiscard]] nlohmann::ordered_json build_json();

/// Flat rows, so that any tool makes CSV of them.
[[nodiscard]] nlohmann::ordered_json counts_json(const TimedInput& input, const RowCounts& counts,
                                                 std::uint64_t max_steps);

[[nodiscard]] std::string counts_table(const RowCounts& counts);

}  // namespace thinbench
