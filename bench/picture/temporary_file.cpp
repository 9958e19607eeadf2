#include "picture/temporary_file.hpp"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace thinbench {
namespace {

[[noreturn]] void throw_errno() {
  throw std::system_error(errno, std::generic_category());
}

std::filesystem::path beside(const std::filesystem::path& target, int attempt) {
  std::string name = ".";
  name.append(target.stem().string(), 0, 100);  // keeps long names within what folders allow
  name.append(".").append(std::to_string(getpid())).append("-").append(std::to_string(attempt));
  name.append(target.extension().string());
  return target.parent_path() / name;
}

}  // namespace

TemporaryFile::TemporaryFile(std::filesystem::path target) : target_(std::move(target)) {
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

TemporaryFile::~TemporaryFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!path_.empty()) unlink(path_.c_str());
}

void TemporaryFile::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw_errno();
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void TemporaryFile::put_in_place() {
  if (close(std::exchange(descriptor_, -1)) != 0) throw_errno();
  if (std::rename(path_.c_str(), target_.c_str()) != 0) throw_errno();
  path_.clear();
}

}  // namespace thinbench
