#include "cli/batch_table.hpp"

#include <filesystem>
#include <optional>

#include "cli/tables.hpp"
#include "support/usage.hpp"
#include "support/whole_file.hpp"

namespace thinbench {

bool is_done(const BatchJob& job, const Manifest& manifest, const BatchOperation& operation,
             const std::string& out) {
  const std::filesystem::path directory = out;
  return manifest.says_done(job, operation.name) &&
         std::filesystem::exists(directory / job.output) &&
         (job.overlay.empty() || std::filesystem::exists(directory / job.overlay));
}

void check_table(const std::string& table, const std::string& manifest,
                 const std::vector<BatchJob>& jobs, const std::string& out) {
  const auto reject = [&table](const std::string& other) {
    throw UsageError("--table: '" + table + "' would replace '" + other + "'; choose another name");
  };
  std::error_code ignored;
  if (place_of(table) == place_of(manifest)) reject(manifest);
  for (const BatchJob& job : jobs) {
    if (std::filesystem::equivalent(table, job.path, ignored)) reject(job.path);
  }
  const std::filesystem::path directory = std::filesystem::path(place_of(table)).parent_path();
  if (directory != place_of(out)) check_target(table);  // which may not be there yet
}

void write_batch_table(const std::string& path, const std::vector<BatchJob>& jobs,
                       const Manifest& manifest, const BatchOperation& operation,
                       const std::string& out, bool is_graph) {
  auto job = jobs.begin();
  write_table(path, is_graph, [&]() -> std::optional<TablePart> {
    while (job != jobs.end() && !is_done(*job, manifest, operation, out)) ++job;
    if (job == jobs.end()) return std::nullopt;
    const TablePart part = {std::filesystem::path(out) / job->output, job->path};
    ++job;
    return part;
  });
}

}  // namespace thinbench
