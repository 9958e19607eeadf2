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

/// "-" is standard input.
[[noreturn]] inline void cannot_read(const std::string& path, const std::string& why) {
  throw FileError("cannot read " + (path == "-" ? "standard input" : "'" + path + "'") + ": " +
                  why);
}

[[noreturn]] inline void cannot_write(const std::string& path, const std::string& why) {
  throw FileError("cannot write '" + path + "': " + why);
}

// The same with what the system says of its last call.

[[noreturn]] inline void cannot_read_by_errno(const std::string& path) {
  const int number = errno;
  cannot_read(path,
              number == ENOENT ? "there is no such file" : std::generic_category().message(number));
}

[[noreturn]] inline void cannot_write_by_errno(const std::string& path) {
  cannot_write(path, std::generic_category().message(errno));
}

}  // namespace thinbench
