#include "support/file_bytes.hpp"

#include <algorithm>
#include <cerrno>
#include <new>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace thinbench {
namespace {

class OpenFile {
 public:
  explicit OpenFile(const std::string& path)
      : path_(path), descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    if (descriptor_ < 0 || fstat(descriptor_, &before_) != 0) cannot_read_by_errno(path);
  }
  ~OpenFile() { close(descriptor_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  [[nodiscard]] mode_t mode() const { return before_.st_mode; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(before_.st_size); }

  void read_all(char* to) const {
    for (std::size_t done = 0; done < size();) {
      const ssize_t got = read(descriptor_, to + done, size() - done);
      if (got < 0 && errno != EINTR) cannot_read_by_errno(path_);
      if (got == 0) changed();
      done += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
    }
  }

  /// By its name, so that another file of this name is a change, too.
  void check_unchanged() const {
    struct stat after {};
    if (stat(path_.c_str(), &after) != 0 || !is_same(before_, after)) changed();
  }

 private:
  static bool is_same(const struct stat& a, const struct stat& b) {
    const auto same = [](const timespec& s, const timespec& t) {
      return s.tv_sec == t.tv_sec && s.tv_nsec == t.tv_nsec;
    };
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino && a.st_size == b.st_size &&
           same(a.st_mtim, b.st_mtim) && same(a.st_ctim, b.st_ctim);
  }
  [[noreturn]] void changed() const { cannot_read(path_, "it changed while it was read"); }

  const std::string& path_;
  int descriptor_;
  struct stat before_ {};
};

FileBytes read_standard_input() {
  constexpr std::size_t most = std::size_t{1} << 32, part = std::size_t{1} << 16;
  std::string bytes;
  for (std::size_t size = 0;;) {
    bytes.resize(size + part);
    const ssize_t got = read(STDIN_FILENO, bytes.data() + size, part);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) cannot_read_by_errno(kStandardStream);
    size += static_cast<std::size_t>(got);
    if (size > most) cannot_read(kStandardStream, "it has more than 2^32 bytes");
    if (got == 0) return {kStandardStream, std::string_view(bytes).substr(0, size)};
  }
}

}  // namespace

FileBytes read_file(const std::string& path, std::size_t max_bytes) {
  const OpenFile file(path);
  if (S_ISDIR(file.mode())) cannot_read(path, "it is a directory");
  if (!S_ISREG(file.mode())) cannot_read(path, "it is not a regular file");
  if (file.size() > max_bytes) {
    cannot_read(path, fmt::format("it has more than {} bytes", fmt::group_digits(max_bytes)));
  }
  try {
    FileBytes bytes(path, file.size());
    file.read_all(bytes.data());
    file.check_unchanged();
    return bytes;
  } catch (const std::bad_alloc&) {
    cannot_read(path, "there is not enough memory for it");
  }
}

FileBytes read_input(const std::string& path) {
  try {
    return path == kStandardStream ? read_standard_input() : read_file(path);
  } catch (const std::bad_alloc&) {
    cannot_read(path, "there is not enough memory for it");
  }
}

}  // namespace thinbench
