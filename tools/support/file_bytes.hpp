// What a file holds, read once. All that the program reads comes from here: images, masks, rules,
// weights, manifests and standard input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "support/file_error.hpp"

namespace thinbench {

/// All bytes of a file, and the name that errors give it.
class FileBytes {
 public:
  FileBytes() = default;
  /// Any bytes, to be written.
  FileBytes(std::string name, std::size_t size)
      : name_(std::move(name)), size_(size), data_(new char[size]) {}
  FileBytes(std::string name, std::string_view text) : FileBytes(std::move(name), text.size()) {
    text.copy(data_.get(), text.size());
  }

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::string_view text() const { return {data_.get(), size_}; }
  [[nodiscard]] char* data() { return data_.get(); }

 private:
  std::string name_;
  std::size_t size_ = 0;
  std::unique_ptr<char[]> data_;
};

/// A regular file as it was at one moment: a file that is another, or has another size or time,
/// after it was read than before is an error, as are devices and pipes, reading which might never
/// end, and more than `max_bytes`. Throws FileError.
[[nodiscard]] FileBytes read_file(const std::string& path, std::size_t max_bytes = SIZE_MAX);

/// The path "-" stands for standard input where an image is read, and for standard output where
/// one is written.
inline constexpr const char* kStandardStream = "-";

/// As read_file; "-" is standard input, up to 2^32 bytes.
[[nodiscard]] FileBytes read_input(const std::string& path);

}  // namespace thinbench
