// Files that are removed if the program ends before they are finished.
#pragma once

#include <cstddef>
#include <string>

namespace thinbench {

/// The name of a file that is removed when this object ends, unless it was renamed, or by a signal
/// before, if remove_unfinished_files_on_signals() was called.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(std::string name);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  /// The file is finished and remains.
  void keep();

 private:
  void leave_slot();

  std::string name_;
  std::size_t slot_;
};

/// From now on, signals that end the program remove all unfinished files first; those that are
/// ignored remain so. Beyond a limit of file sizes, writing fails and the program goes on. For the
/// beginning of main().
void remove_unfinished_files_on_signals();

}  // namespace thinbench
