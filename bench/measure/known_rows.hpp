// Rows that are ready to be measured: verified and called a few times, here or by a process before.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "measure/inputs.hpp"
#include "measure/timed_row.hpp"

namespace thinbench {

/// A row, the time of its fastest call, and what it gave.
struct KnownRow {
  TimedRow row;
  double seconds;
  std::string hash;  // of the verified result
};

/// 16 hexadecimal digits that name a result, image and numbers.
[[nodiscard]] std::string hash_of(const Outcome& outcome);

/// Calls the row a few times.
[[nodiscard]] KnownRow calibrate(const TimedRow& row);

/// The same for all. Rows of which a call takes more than `max_seconds` become skipped.
[[nodiscard]] std::vector<KnownRow> calibrate_rows(Selection& selection, double max_seconds);

/// "name", "width", "height" and the hashes of both images.
[[nodiscard]] nlohmann::ordered_json input_json(const TimedInput& input);

/// What a row is: "case", the unique name; "operation", the plain one; "border" (empty where the
/// operation has none), "max_iterations" (null for no limit), "technique", "isa", "threads",
/// "scope" and "input".
[[nodiscard]] nlohmann::ordered_json row_json(const TimedRow& row);

/// Facts on what was verified, for a program that starts measuring processes and reads their
/// samples: "sources", "inputs", "peers", "rows" by name, "skipped", "verified" and "mismatches".
[[nodiscard]] nlohmann::ordered_json facts_json(const InputChoice& sources,
                                                const std::vector<TimedInput>& inputs,
                                                const Selection& selection,
                                                const std::vector<KnownRow>& rows);

/// What a process before has verified, from its facts.
struct Known {
  /// Rows point to `operations` and to `inputs`. Throws FileError, and std::runtime_error where the
  /// file holds no facts or a row is not known.
  Known(const std::string& file, const std::vector<Operation>& operations);

  std::vector<TimedInput> inputs;
  std::vector<KnownRow> rows;
};

}  // namespace thinbench
