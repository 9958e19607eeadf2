// The manifest of a batch: a file with a line for each page that is done or has failed.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "batch/jobs.hpp"
#include "batch/manifest_text.hpp"
#include "support/locked_file.hpp"

namespace thinbench {

/// Lines are appended whole, so that a program that is killed leaves at most one truncated line,
/// the last. Only one program at a time can have a manifest open. Throws FileError where the file
/// cannot be written.
class Manifest {
 public:
  /// Begins a new manifest, or goes on with one where `resumes`. What is not a manifest is never
  /// replaced.
  Manifest(std::string path, bool resumes);

  /// Whether the last line of each of the job's pages says that this operation made it of the job's
  /// file.
  [[nodiscard]] bool says_done(const BatchJob& job, const std::string& operation) const;

  void append(const BatchRecord& record);

  /// Where runs were resumed: leaves the last line of each page, in the order of the jobs. Lines of
  /// other jobs come first.
  void put_in_order(const std::vector<BatchJob>& jobs);

 private:
  using Key = std::pair<std::string, int>;  // output and page

  void read_lines();
  void write_text(const std::string& text);

  std::string path_;
  TableFormat format_;
  bool resumes_;
  std::optional<LockedFile> file_;
  std::size_t size_ = 0;
  std::map<Key, ManifestLine> lines_;  // the last of each key
};

}  // namespace thinbench
