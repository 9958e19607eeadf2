#include "support/regular_file.hpp"

#include <algorithm>
#include <cerrno>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/content_hash.hpp"

namespace thinbench {
namespace {

class RegularFile {
 public:
  explicit RegularFile(const std::string& path)
      : path_(path), descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    if (descriptor_ < 0) cannot_read_by_errno(path);
    struct stat facts {};
    const int failed = fstat(descriptor_, &facts);
    size_ = facts.st_size;
    if (failed == 0 && S_ISREG(facts.st_mode)) return;
    close(descriptor_);
    cannot_read(path, S_ISDIR(facts.st_mode) ? "it is a directory" : "it is not a regular file");
  }
  ~RegularFile() { close(descriptor_); }
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;
  RegularFile(RegularFile&&) = delete;
  RegularFile& operator=(RegularFile&&) = delete;

  [[nodiscard]] std::int64_t size() const { return size_; }

  /// The next bytes; fewer at the end.
  [[nodiscard]] std::string bytes(std::size_t count) const {
    std::string text(count, '\0');
    std::size_t done = 0;
    while (done < count) {
      const ssize_t got = read(descriptor_, text.data() + done, count - done);
      if (got < 0 && errno != EINTR) cannot_read_by_errno(path_);
      if (got == 0) break;
      done += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
    }
    text.resize(done);
    return text;
  }

 private:
  const std::string& path_;
  int descriptor_;
  std::int64_t size_ = 0;
};

}  // namespace

std::int64_t regular_file_bytes(const std::string& path) {
  return RegularFile(path).size();
}

std::string beginning_of(const std::string& path, std::size_t count) {
  const RegularFile file(path);
  return file.bytes(std::min(count, static_cast<std::size_t>(file.size())));
}

std::string read_whole_file(const std::string& path, std::size_t max_bytes) {
  const RegularFile file(path);
  const auto size = static_cast<std::size_t>(file.size());
  if (size > max_bytes)
    cannot_read(path, fmt::format("it has more than {} bytes", fmt::group_digits(max_bytes)));
  return file.bytes(size);
}

std::uint64_t hash_of_file(const std::string& path) {
  constexpr std::size_t part = 1 << 18;
  const RegularFile file(path);
  std::uint64_t hash = 0;
  std::string bytes;
  do {
    bytes = file.bytes(part);
    hash = hash_of(bytes.data(), bytes.size(), hash);
  } while (bytes.size() == part);
  return hash;
}

namespace {

int copy_of_standard_input() {
  constexpr std::int64_t most = std::int64_t{1} << 32;
  const int file = memfd_create("standard input", MFD_CLOEXEC);
  if (file < 0) cannot_read_by_errno("standard input");
  std::string part(std::size_t{1} << 16, '\0');
  for (std::int64_t bytes = 0;;) {
    const ssize_t got = read(STDIN_FILENO, part.data(), part.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) cannot_read_by_errno("standard input");
    if (got == 0) return file;
    bytes += got;
    if (bytes > most) cannot_read("standard input", "it has more than 2^32 bytes");
    if (write(file, part.data(), static_cast<std::size_t>(got)) != got) {
      cannot_read("standard input", "there is not enough memory for it");
    }
  }
}

}  // namespace

std::string path_of_standard_input() {
  static const int file = copy_of_standard_input();
  return "/proc/self/fd/" + std::to_string(file);
}

}  // namespace thinbench
