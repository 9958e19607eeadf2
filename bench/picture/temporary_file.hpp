// A file that is written beside its target and takes the target's place when it is complete.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace thinbench {

/// The temporary file is removed unless it was put in place. Throws std::system_error.
class TemporaryFile {
 public:
  /// Creates an empty file in the target's folder, with the target's ending.
  explicit TemporaryFile(std::filesystem::path target);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile(TemporaryFile&&) = delete;
  TemporaryFile& operator=(TemporaryFile&&) = delete;

  void write(std::span<const std::uint8_t> bytes);
  /// Closes the file and renames it to the target.
  void put_in_place();

 private:
  std::filesystem::path target_;
  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace thinbench
