// Why a file could not be read or written.
#pragma once

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

namespace thinbench {

/// One line that names the file.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[noreturn]] inline void cannot_read(const std::string& path, const std::string& why) {
  throw FileError("cannot read '" + path + "': " + why);
}

[[noreturn]] inline void cannot_write(const std::string& path, const std::string& why) {
  throw FileError("cannot write '" + path + "': " + why);
}

/// What the system says of its last call.
[[nodiscard]] inline std::string errno_text() {
  return errno == ENOENT ? "there is no such file" : std::generic_category().message(errno);
}

}  // namespace thinbench
