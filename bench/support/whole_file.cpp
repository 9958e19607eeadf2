#include "support/whole_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

namespace thinbench {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& why) {
  throw FileError("cannot write '" + path + "': " + why);
}

[[noreturn]] void fail_by_errno(const std::string& path) {
  fail(path, std::generic_category().message(errno));
}

/// A new hidden file beside the target, removed unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& target)
      : name_(std::filesystem::path(target).parent_path() / ".thinbench-XXXXXX") {
    const int descriptor = mkstemp(name_.data());
    if (descriptor < 0) fail_by_errno(target);
    const mode_t mask = umask(0);
    umask(mask);
    fchmod(descriptor, 0666 & ~mask);  // mkstemp creates private files
    close(descriptor);
  }
  ~TemporaryFile() { unlink(name_.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile(TemporaryFile&&) = delete;
  TemporaryFile& operator=(TemporaryFile&&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
};

}  // namespace

void check_target(const std::string& path) {
  const std::filesystem::path directory = std::filesystem::path(path).parent_path();
  std::error_code ignored;
  if (path.empty()) fail(path, "its name is empty");
  if (!directory.empty() && !std::filesystem::is_directory(directory, ignored)) {
    fail(path, "there is no directory '" + directory.string() + "'");
  }
  if (std::filesystem::is_directory(path, ignored)) fail(path, "it is a directory");
  if (std::filesystem::exists(path, ignored) && access(path.c_str(), W_OK) != 0) {
    fail(path, "it is write-protected");
  }
}

void write_whole_file(const std::string& path, std::string_view bytes) {
  check_target(path);
  const TemporaryFile file(path);
  std::ofstream stream(file.name(), std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream || std::rename(file.name().c_str(), path.c_str()) != 0) fail_by_errno(path);
}

}  // namespace thinbench
