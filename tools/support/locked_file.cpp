#include "support/locked_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/file_error.hpp"

namespace thinbench {
namespace {

/// Whether a file still has the name by which it was opened.
bool is_at(int descriptor, const std::string& path) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

/// Throws FileError where the file cannot be opened or another process has locked it.
int open_locked(const std::string& path, const std::string& purpose, int flags) {
  const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | flags, 0666);
  if (descriptor < 0) cannot_write_by_errno(purpose);
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  const int error = errno;
  close(descriptor);
  if (error == EWOULDBLOCK) cannot_write(purpose, "another run is writing it");
  errno = error;
  cannot_write_by_errno(purpose);
}

}  // namespace

// Another run may have replaced or removed the file after it was opened and before it was locked.
LockedFile::LockedFile(const std::string& path, const std::string& purpose, int flags)
    : descriptor_(open_locked(path, purpose, flags)) {
  while (!is_at(descriptor_, path)) {
    close(descriptor_);
    descriptor_ = open_locked(path, purpose, flags);
  }
}

LockedFile::~LockedFile() {
  close(descriptor_);
}

}  // namespace thinbench
