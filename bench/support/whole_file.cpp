#include "support/whole_file.hpp"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace thinbench {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw FileError("cannot write '" + path + "': " + why);
}

[[noreturn]] void throw_errno() {
  throw std::system_error(errno, std::generic_category());
}

/// A file that is removed unless it was put in place.
class TemporaryFile {
 public:
  /// Creates an empty file in the target's folder.
  explicit TemporaryFile(std::filesystem::path target) : target_(std::move(target)) {
    constexpr int attempts = 100;
    constexpr mode_t readable_and_writable = 0666;  // less what the user's umask takes away
    for (int attempt = 0; descriptor_ < 0 && attempt < attempts; ++attempt) {
      path_ = beside(target_, attempt);
      descriptor_ =
          open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, readable_and_writable);
      if (descriptor_ < 0 && errno != EEXIST) throw_errno();
    }
    if (descriptor_ < 0) throw_errno();
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!path_.empty()) unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile(TemporaryFile&&) = delete;
  TemporaryFile& operator=(TemporaryFile&&) = delete;

  void write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) throw_errno();
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  /// Closes the file and renames it to the target.
  void put_in_place() {
    if (close(std::exchange(descriptor_, -1)) != 0) throw_errno();
    if (std::rename(path_.c_str(), target_.c_str()) != 0) throw_errno();
    path_.clear();
  }

 private:
  static std::filesystem::path beside(const std::filesystem::path& target, int attempt) {
    std::string name = ".";
    name.append(target.stem().string(), 0, 100);  // keeps long names within what folders allow
    name.append(".").append(std::to_string(getpid())).append("-").append(std::to_string(attempt));
    return target.parent_path() / name;
  }

  std::filesystem::path target_;
  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace

void check_target(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code ignored;
  if (path.empty()) refuse(path, "its name is empty");
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) {
    refuse(path, "there is no directory '" + folder.string() + "'");
  }
  if (std::filesystem::is_directory(path, ignored)) refuse(path, "it is a directory");
  if (std::filesystem::exists(path, ignored) && access(path.c_str(), W_OK) != 0) {
    refuse(path, "it is write-protected");
  }
}

void write_whole_file(const std::string& path, std::string_view bytes) {
  check_target(path);
  try {
    TemporaryFile file(path);
    file.write(bytes);
    file.put_in_place();
  } catch (const std::system_error& error) {
    refuse(path, error.code().message());
  }
}

}  // namespace thinbench
