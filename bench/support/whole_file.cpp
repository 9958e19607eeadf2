#include "support/whole_file.hpp"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
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

constexpr std::string_view kHiddenPrefix = ".thinbench-";

/// The umask applies, as it does not to files of mkstemp.
int create_new(const std::string& path) {
  return open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

bool has_name(int descriptor) {
  struct stat facts {};
  return fstat(descriptor, &facts) == 0 && facts.st_nlink > 0;
}

/// A new hidden file beside the target, removed unless it was renamed. It is locked while this
/// program works on it.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& target) {
    const std::filesystem::path directory = std::filesystem::path(target).parent_path();
    const std::string extension = std::filesystem::path(target).extension();
    do {  // again if another program took it for an abandoned file before it was locked
      if (descriptor_ >= 0) close(descriptor_);
      const std::string number = std::to_string(std::random_device()());
      name_ = directory / (std::string(kHiddenPrefix) + number + extension);
      descriptor_ = create_new(name_);
      if (descriptor_ < 0 && errno != EEXIST) fail_by_errno(target);
      flock(descriptor_, LOCK_EX);
    } while (descriptor_ < 0 || !has_name(descriptor_));
  }
  ~TemporaryFile() {
    unlink(name_.c_str());
    close(descriptor_);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile(TemporaryFile&&) = delete;
  TemporaryFile& operator=(TemporaryFile&&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
  int descriptor_ = -1;
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
  write_whole_file(path, [&](const std::string& name) {
    std::ofstream stream(name, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) fail_by_errno(path);
  });
}

void write_whole_file(const std::string& path,
                      const std::function<void(const std::string& name)>& write) {
  check_target(path);
  const TemporaryFile file(path);
  write(file.name());
  if (std::rename(file.name().c_str(), path.c_str()) != 0) fail_by_errno(path);
}

void remove_abandoned_files(const std::string& directory) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(directory, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind(kHiddenPrefix, 0) != 0) continue;
    const int descriptor = open(entry.path().c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) continue;
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) unlink(entry.path().c_str());
    close(descriptor);
  }
}

}  // namespace thinbench
