// The files beside the output of a run on an image larger than memory.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "images/packed_file.hpp"
#include "out_of_core/checkpoint.hpp"
#include "out_of_core/conversion.hpp"
#include "support/locked_file.hpp"
#include "support/unfinished_file.hpp"

namespace thinbench {

/// Pass p reads what pass p - 1 wrote, the first one the input, and writes file p % 2. Both have
/// the format of the output, so that the last one written becomes the output. An input that must be
/// unpacked is unpacked into file 1, which only the second pass writes.
class WorkFiles {
 public:
  /// Checks that the directory of `out` has room for `files` work files and that no other run
  /// writes them.
  WorkFiles(const std::string& in, const std::string& out, const PackedFormat& format,
            Conversion conversion, int files);
  /// Removes the work files unless there is a checkpoint; so do signals that end the program.
  ~WorkFiles();
  WorkFiles(const WorkFiles&) = delete;
  WorkFiles& operator=(const WorkFiles&) = delete;
  WorkFiles(WorkFiles&&) = delete;
  WorkFiles& operator=(WorkFiles&&) = delete;

  /// The checkpoint of an interrupted run, if there is one.
  [[nodiscard]] std::optional<Checkpoint> load(const std::string& identity,
                                               const CheckpointLimits& limits) const;
  /// Removes the checkpoint: the run begins again, or has ended.
  void drop_checkpoint();

  /// Opens the files of a pass; the target is new where nothing of it is needed.
  void open(int pass, bool new_target);
  [[nodiscard]] const PackedFile& source() const { return source_; }
  [[nodiscard]] const PackedFile& target() const { return target_; }
  /// Saves the state after a pass, with all that the pass wrote.
  void save(const std::string& identity, const Checkpoint& checkpoint);
  /// Makes the target the output, or the output of the target.
  void finish();

 private:
  [[nodiscard]] PackedFile open_input() const;
  void check_space(int files) const;

  std::string in_;
  std::string out_;
  PackedFormat format_;
  Conversion conversion_;
  std::array<std::string, 2> names_;
  std::string state_name_;
  std::optional<LockedFile> lock_;
  std::optional<UnfinishedFile> new_file_;  // renamed once it is whole
  /// The work files where nothing is there to resume.
  std::array<std::optional<UnfinishedFile>, 2> unfinished_;
  PackedFile source_;
  PackedFile target_;
};

}  // namespace thinbench
