// One table of what a batch found in all images.
#pragma once

#include <string>
#include <vector>

#include "batch/jobs.hpp"
#include "batch/manifest.hpp"
#include "batch/pipeline.hpp"

namespace thinbench {

/// Whether this operation has written all results of the job, and they are there.
[[nodiscard]] bool is_done(const BatchJob& job, const Manifest& manifest,
                           const BatchOperation& operation, const std::string& out);

/// Before the work: rejects a table that would replace another file of this batch or that cannot be
/// written. Throws UsageError and FileError.
void check_table(const std::string& table, const std::string& manifest,
                 const std::vector<BatchJob>& jobs, const std::string& out);

/// With a row for each region or edge of every image that is done, from the results: the same after
/// a run that was killed and resumed. Throws FileError.
void write_batch_table(const std::string& path, const std::vector<BatchJob>& jobs,
                       const Manifest& manifest, const BatchOperation& operation,
                       const std::string& out, bool is_graph);

}  // namespace thinbench
