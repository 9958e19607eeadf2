// Files that one process at a time works on.
#pragma once

#include <string>

namespace thinbench {

/// An open file that no other process has locked; it is created if there is none.
class LockedFile {
 public:
  /// `flags` of open(2) beside O_RDWR and O_CREAT; `purpose` is the file that the lock protects,
  /// for the message. Throws FileError.
  LockedFile(const std::string& path, const std::string& purpose, int flags = 0);
  ~LockedFile();
  LockedFile(const LockedFile&) = delete;
  LockedFile& operator=(const LockedFile&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

}  // namespace thinbench
