// A file in memory, for readers that take a path.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include "byte_source.hpp"

namespace thinbench {

class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("input", MFD_CLOEXEC)) {
    must(descriptor_ >= 0, "no file in memory");
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  MemoryFile(MemoryFile&&) = delete;
  MemoryFile& operator=(MemoryFile&&) = delete;

  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

  /// Replaces what is in the file.
  void hold(std::span<const std::uint8_t> bytes) const {
    const bool emptied = ftruncate(descriptor_, 0) == 0;
    const ssize_t written = pwrite(descriptor_, bytes.data(), bytes.size(), 0);
    must(emptied && written == static_cast<ssize_t>(bytes.size()), "memory is full");
  }

 private:
  int descriptor_;
};

}  // namespace thinbench
