#include "support/whole_file.hpp"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <random>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/unfinished_file.hpp"

namespace thinbench {
namespace {

constexpr std::string_view kHiddenPrefix = ".thinbench-";

/// The umask applies, as it does not to files of mkstemp.
int create_new(const std::string& path, mode_t mode) {
  return open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode);
}

bool has_name(int descriptor) {
  struct stat facts {};
  return fstat(descriptor, &facts) == 0 && facts.st_nlink > 0;
}

/// Unlinks a hidden file that no program is writing.
void remove_if_abandoned(const std::string& name) {
  const int descriptor = open(name.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return;
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) unlink(name.c_str());
  close(descriptor);
}

/// For the first attempt the same name for each target, so that the next run removes what a killed
/// one left.
std::string hidden_name_for(const std::filesystem::path& target, bool is_first,
                            const std::string& extension) {
  const std::size_t number =
      is_first ? std::hash<std::string>()(target.filename()) : std::random_device()();
  return target.parent_path() / (std::string(kHiddenPrefix) + std::to_string(number) + extension);
}

/// A new hidden file beside the target, removed unless it was renamed. It is locked while this
/// program works on it. Who must not read the target cannot read it either.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path) {
    const std::filesystem::path target = target_of(path);
    const std::string extension = std::filesystem::path(path).extension();
    struct stat old {};
    const mode_t mode = stat(target.c_str(), &old) == 0 ? old.st_mode & 0666 : 0666;
    bool is_first = true;
    do {  // again if another program took it for an abandoned file before it was locked
      if (descriptor_ >= 0) close(descriptor_);
      const std::string hidden = hidden_name_for(target, is_first, extension);
      if (is_first) remove_if_abandoned(hidden);
      is_first = false;
      file_.emplace(hidden);
      descriptor_ = create_new(name(), mode);
      if (descriptor_ < 0 && errno != EEXIST) cannot_write_by_errno(path);
      if (descriptor_ < 0) file_->keep();  // it is another program's
      flock(descriptor_, LOCK_EX);
    } while (descriptor_ < 0 || !has_name(descriptor_));
  }
  ~TemporaryFile() { close(descriptor_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile(TemporaryFile&&) = delete;
  TemporaryFile& operator=(TemporaryFile&&) = delete;

  [[nodiscard]] const std::string& name() const { return file_->name(); }

 private:
  std::optional<UnfinishedFile> file_;
  int descriptor_ = -1;
};

/// Whether the other names of a file (hard links), its owner and its group are not lost when
/// another file takes its place.
bool is_replaceable(const struct stat& old, const struct stat& finished) {
  return old.st_nlink == 1 && old.st_uid == finished.st_uid && old.st_gid == finished.st_gid;
}

void overwrite(const std::string& path, const std::string& finished) {
  errno = 0;
  std::ifstream from(finished, std::ios::binary);
  std::ofstream to(path, std::ios::binary | std::ios::trunc);
  if (from.peek() != std::ifstream::traits_type::eof()) to << from.rdbuf();
  to.close();
  if (!from.is_open() || !to) cannot_write_by_errno(path);
  unlink(finished.c_str());
}

}  // namespace

std::string target_of(const std::string& path) {
  constexpr int max_links = 40;  // as Linux
  std::filesystem::path target = path;
  std::error_code ignored;
  for (int links = 0; std::filesystem::is_symlink(target, ignored); ++links) {
    if (links == max_links) cannot_write(path, std::generic_category().message(ELOOP));
    target = target.parent_path() / std::filesystem::read_symlink(target, ignored);
  }
  return target;
}

void check_target(const std::string& path) {
  const std::string target = target_of(path);
  const std::filesystem::path directory = std::filesystem::path(target).parent_path();
  std::error_code ignored;
  if (path.empty()) cannot_write(path, "its name is empty");
  if (!directory.empty() && !std::filesystem::is_directory(directory, ignored)) {
    cannot_write(path, "there is no directory '" + directory.string() + "'");
  }
  const std::filesystem::file_status status = std::filesystem::status(target, ignored);
  if (!std::filesystem::exists(status)) return;
  if (std::filesystem::is_directory(status)) cannot_write(path, "it is a directory");
  if (!std::filesystem::is_regular_file(status)) cannot_write(path, "it is not a regular file");
  if (access(target.c_str(), W_OK) != 0) cannot_write(path, "it is write-protected");
}

void replace_file(const std::string& path, const std::string& finished) {
  const std::string target = target_of(path);
  struct stat old {};
  struct stat facts {};
  if (stat(target.c_str(), &old) == 0) {
    if (stat(finished.c_str(), &facts) != 0) cannot_write_by_errno(path);
    if (!is_replaceable(old, facts)) return overwrite(target, finished);
    if (chmod(finished.c_str(), old.st_mode & 07777) != 0) cannot_write_by_errno(path);
  }
  if (std::rename(finished.c_str(), target.c_str()) != 0) cannot_write_by_errno(path);
}

void write_whole_file(const std::string& path, std::string_view bytes) {
  write_whole_file(path, [&](const std::string& name) {
    std::ofstream stream(name, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) cannot_write_by_errno(path);
  });
}

void write_whole_file(const std::string& path,
                      const std::function<void(const std::string& name)>& write) {
  check_target(path);
  const TemporaryFile file(path);
  write(file.name());
  replace_file(path, file.name());
}

void remove_abandoned_files(const std::string& directory) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(directory, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind(kHiddenPrefix, 0) != 0) continue;
    remove_if_abandoned(entry.path());
  }
}

}  // namespace thinbench
