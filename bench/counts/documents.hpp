// Counts as a JSON file and as a table of text.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "counts/row_counts.hpp"

namespace thinbench {

/// Flat rows, so that any tool makes CSV of them.
[[nodiscard]] nlohmann::ordered_json counts_json(const TimedInput& input, const RowCounts& counts,
                                                 std::uint64_t max_steps);

[[nodiscard]] std::string counts_table(const RowCounts& counts);

}  // namespace thinbench
