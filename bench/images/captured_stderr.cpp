#include "images/captured_stderr.hpp"

#include <cstdio>

#include <sys/mman.h>
#include <unistd.h>

namespace thinbench {

CapturedStderr::CapturedStderr()
    : original_(dup(STDERR_FILENO)), caught_(memfd_create("captured stderr", MFD_CLOEXEC)) {
  std::fflush(stderr);
  if (original_ >= 0 && caught_ >= 0) dup2(caught_, STDERR_FILENO);
}

CapturedStderr::~CapturedStderr() {
  std::fflush(stderr);
  if (original_ >= 0 && caught_ >= 0) dup2(original_, STDERR_FILENO);
  if (original_ >= 0) close(original_);
  if (caught_ >= 0) close(caught_);
}

std::string CapturedStderr::text() const {
  std::fflush(stderr);
  std::string text(65536, '\0');
  const ssize_t length = caught_ >= 0 ? pread(caught_, text.data(), text.size(), 0) : 0;
  text.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
  return text;
}

}  // namespace thinbench
