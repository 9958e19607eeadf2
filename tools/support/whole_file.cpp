#include "support/whole_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>
#include <random>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/sendfile.h>
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

/// What stands in the place of an output. Throws FileError where it cannot be written.
struct Target {
  std::string path;   // as given
  std::string place;  // through links
  struct stat old {};
  bool exists = false;

  explicit Target(const std::string& given) : path(given), place(given) {
    if (given.empty()) cannot_write(path, "its name is empty");
    exists = lstat(place.c_str(), &old) == 0;
    if (!exists && errno != ENOENT && errno != ENOTDIR) cannot_write_by_errno(path);
    if (exists && S_ISLNK(old.st_mode)) {
      place = target_of(path);
      exists = stat(place.c_str(), &old) == 0;
    }
    if (!exists) return;
    if (S_ISDIR(old.st_mode)) cannot_write(path, "it is a directory");
    if (!S_ISREG(old.st_mode)) cannot_write(path, "it is not a regular file");
    if (access(place.c_str(), W_OK) != 0) cannot_write(path, "it is write-protected");
  }
};

void check_directory(const Target& target) {
  const std::filesystem::path directory = std::filesystem::path(target.place).parent_path();
  std::error_code ignored;
  if (!directory.empty() && !std::filesystem::is_directory(directory, ignored)) {
    cannot_write(target.path, "there is no directory '" + directory.string() + "'");
  }
}

/// A new hidden file beside the target, removed unless it was renamed. It is locked while this
/// program works on it. Who must not read the target cannot read it either.
class TemporaryFile {
 public:
  explicit TemporaryFile(const Target& target) {
    const std::string extension = std::filesystem::path(target.path).extension();
    const mode_t mode = target.exists ? target.old.st_mode & 0666 : 0666;
    bool is_first = true;
    do {  // again if another program took it for an abandoned file before it was locked
      if (descriptor_ >= 0) close(descriptor_);
      file_.emplace(hidden_name_for(target.place, is_first, extension));
      descriptor_ = create_new(name(), mode);
      if (descriptor_ < 0 && errno == EEXIST && is_first) {
        remove_if_abandoned(name());
        descriptor_ = create_new(name(), mode);
      }
      if (descriptor_ < 0) reject_unless_taken(target);
      is_first = false;
      flock(descriptor_, LOCK_EX);
    } while (descriptor_ < 0 || !has_name(descriptor_));
  }
  ~TemporaryFile() { close(descriptor_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] const std::string& name() const { return file_->name(); }
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  /// It is another program's, or cannot be made.
  void reject_unless_taken(const Target& target) {
    const int number = errno;
    file_->keep();
    check_directory(target);
    errno = number;
    if (number != EEXIST) cannot_write_by_errno(target.path);
  }

  std::optional<UnfinishedFile> file_;
  int descriptor_ = -1;
};

/// Whether a finished file can take the place of another: it has no other names (hard links), and
/// its owner and its group can be given to the finished one.
bool can_be_replaced(const struct stat& old, const std::string& finished) {
  struct stat facts {};
  if (old.st_nlink > 1 || stat(finished.c_str(), &facts) != 0) return false;
  if (old.st_uid == facts.st_uid && old.st_gid == facts.st_gid) return true;
  return lchown(finished.c_str(), old.st_uid, old.st_gid) == 0;
}

/// Gives a file one more name, which no other file has.
std::string second_name(const std::string& file, const std::string& wish) {
  std::string name = wish;
  for (int i = 2; link(file.c_str(), name.c_str()) != 0; ++i) {
    if (errno != EEXIST) cannot_write_by_errno(name);
    name = wish + std::to_string(i);
  }
  return name;
}

class Descriptor {
 public:
  Descriptor(const std::string& path, int flags) : number_(open(path.c_str(), flags | O_CLOEXEC)) {
    if (number_ < 0) cannot_write_by_errno(path);
  }
  ~Descriptor() { close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] off_t size() const {
    struct stat facts {};
    return fstat(number_, &facts) == 0 ? facts.st_size : 0;
  }

 private:
  int number_;
};

/// Takes the room on the disk for a file that may grow; its bytes remain as they are.
void reserve(const Descriptor& to, off_t size, const std::string& path) {
  const off_t old_size = to.size();
  int error = 0;
  do {
    error = size > 0 ? posix_fallocate(to.number(), 0, size) : 0;
  } while (error == EINTR);
  if (error == 0) return;
  static_cast<void>(!ftruncate(to.number(), old_size));
  cannot_write(path, std::generic_category().message(error));
}

/// False with errno where not all bytes are on the disk.
bool copy_bytes(const Descriptor& from, const Descriptor& to) {
  const off_t size = from.size();
  for (off_t done = 0; done < size;) {
    const ssize_t count =
        sendfile(to.number(), from.number(), nullptr, static_cast<std::size_t>(size - done));
    if (count < 0 && errno == EINTR) continue;
    if (count == 0) errno = EIO;  // it became shorter
    if (count <= 0) return false;
    done += count;
  }
  return ftruncate(to.number(), size) == 0 && fsync(to.number()) == 0;
}

/// Copies into a file whose names and owner remain. Until the copy is whole, the finished file has
/// a second name, which neither a signal nor a failure removes.
void overwrite(const std::string& path, const std::string& finished) {
  const Descriptor from(finished, O_RDONLY);
  const Descriptor to(path, O_WRONLY);
  reserve(to, from.size(), path);
  const std::string whole = second_name(finished, path + ".whole");
  if (!copy_bytes(from, to)) {
    cannot_write(path,
                 std::generic_category().message(errno) + "; all of it is in '" + whole + "'");
  }
  unlink(whole.c_str());
  unlink(finished.c_str());
}

}  // namespace

std::string target_of(const std::string& path) {
  constexpr int max_links = 40;  // as Linux
  std::filesystem::path target = path;
  std::error_code ignored;
  for (int links = 0; std::filesystem::is_symlink(target, ignored); ++links) {
    if (links == max_links) cannot_write(path, std::generic_category().message(ELOOP));
    const auto directory = std::filesystem::weakly_canonical(target.parent_path(), ignored);
    if (directory.string().starts_with("/proc/")) {
      cannot_write(path, "it is an open file or a stream; give the name of a file");
    }
    target = target.parent_path() / std::filesystem::read_symlink(target, ignored);
  }
  return target;
}

std::string place_of(const std::string& path) {
  std::error_code error;
  std::filesystem::path place = std::filesystem::absolute(target_of(path), error);
  if (!place.has_filename()) place = place.parent_path();
  if (!error) place = std::filesystem::weakly_canonical(place, error);
  if (error) cannot_write(path, error.message());
  return place;
}

void check_target(const std::string& path) {
  check_directory(Target(path));
}

namespace {

/// Gives a finished file the place of the target.
void replace(const Target& target, const std::string& finished) {
  if (target.exists) {
    if (!can_be_replaced(target.old, finished)) return overwrite(target.place, finished);
    if (chmod(finished.c_str(), target.old.st_mode & 07777) != 0)
      cannot_write_by_errno(target.path);
  }
  if (std::rename(finished.c_str(), target.place.c_str()) != 0) cannot_write_by_errno(target.path);
}

}  // namespace

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return false;
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
  return true;
}

void write_whole_file(const std::string& path, std::string_view bytes) {
  const Target target(path);
  const TemporaryFile file(target);
  if (!write_all(file.descriptor(), bytes)) cannot_write_by_errno(path);
  replace(target, file.name());
}

void write_whole_file(const std::string& path,
                      const std::function<void(const std::string& name)>& write) {
  const Target target(path);
  const TemporaryFile file(target);
  write(file.name());
  replace(target, file.name());
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
