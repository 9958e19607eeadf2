// Files of packed pixels: PBM (P4) and raw bits. Any part of them can be read and written.
#pragma once

#include <cstdint>
#include <string>

#include "support/file_error.hpp"
#include "thinbench/packed.hpp"

namespace thinbench {

/// How pixels lie in a file: a header, then rows of packed_row_bytes(width) bytes. 1 is foreground.
struct PackedFormat {
  Index width = 0;
  Index height = 0;
  BitOrder order = BitOrder::msb_first;
  std::string header = {};

  [[nodiscard]] Index row_bytes() const { return packed_row_bytes(width); }
  [[nodiscard]] Index header_bytes() const { return static_cast<Index>(header.size()); }
  [[nodiscard]] Index file_bytes() const { return header_bytes() + row_bytes() * height; }
};

/// The format of a PBM file (P4). Throws FileError.
[[nodiscard]] PackedFormat pbm_format(const std::string& path);

/// A rectangle of pixels. `x` is a multiple of 8, and so is the width unless the rectangle ends
/// with the image's last column: it consists of whole bytes.
struct Block {
  Index x;
  Index y;
  Index width;
  Index height;

  [[nodiscard]] Index row_bytes() const { return packed_row_bytes(width); }
};

/// An open file. Threads may read and write different blocks at the same time. Errors are
/// FileError: one line that names the file.
class PackedFile {
 public:
  /// Opens a file to read. Rejects a file that is not exactly as long as the format says.
  static PackedFile open(const std::string& path, const PackedFormat& format);
  /// Creates or overwrites a file, with all pixels 0.
  static PackedFile create(const std::string& path, const PackedFormat& format);
  /// Opens a file of this format to read and write.
  static PackedFile reopen(const std::string& path, const PackedFormat& format);

  PackedFile() = default;
  PackedFile(PackedFile&& other) noexcept;
  PackedFile& operator=(PackedFile&& other) noexcept;
  PackedFile(const PackedFile&) = delete;
  PackedFile& operator=(const PackedFile&) = delete;
  ~PackedFile();

  [[nodiscard]] const PackedFormat& format() const { return format_; }
  [[nodiscard]] const std::string& path() const { return path_; }

  /// Reads a block into contiguous rows. Unused bits of the last byte of rows become 0.
  void read(const Block& block, std::uint8_t* to) const;
  /// Writes a block from rows with this stride, in bytes.
  void write(const Block& block, const std::uint8_t* from, Index stride) const;
  /// Returns when all that was written is on the disk.
  void synchronise() const;

 private:
  PackedFile(const std::string& path, const PackedFormat& format, int flags);

  void check_length() const;
  void read_bytes(std::uint8_t* to, Index count, Index offset) const;
  void write_bytes(const std::uint8_t* from, Index count, Index offset) const;
  [[nodiscard]] Index offset_of(const Block& block) const;
  /// Whether rows of a block follow each other in the file.
  [[nodiscard]] bool has_whole_rows(const Block& block) const;

  std::string path_;
  PackedFormat format_;
  int descriptor_ = -1;
};

/// The number of foreground pixels of a part of a packed image whose unused bits are 0. The part
/// consists of whole bytes.
[[nodiscard]] Index packed_foreground(const ConstPackedView& image);

}  // namespace thinbench
