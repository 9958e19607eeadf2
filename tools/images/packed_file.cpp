#include "images/packed_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "images/pnm_header.hpp"
#include "support/regular_file.hpp"

namespace thinbench {
namespace {

/// The number of set bits, by operations that compilers vectorise on any processor.
Index bits_of(std::uint64_t word) {
  word -= word >> 1 & 0x5555555555555555;
  word = (word & 0x3333333333333333) + (word >> 2 & 0x3333333333333333);
  word = (word + (word >> 4)) & 0x0F0F0F0F0F0F0F0F;
  word += word >> 8;
  word += word >> 16;
  word += word >> 32;
  return static_cast<Index>(word & 0x7F);
}

}  // namespace

PackedFormat pbm_format(const std::string& path) {
  const std::string text = beginning_of(path, kPnmHeaderBytes);
  if (text.rfind("P4", 0) != 0)
    cannot_read(path, "it is not a binary PBM file (P4), as OUT requires");
  PnmHeader header(text);
  const std::optional<Index> width = header.number();
  const std::optional<Index> height = header.number();
  const std::optional<std::string> whole = header.whole();
  if (!width || !height || !whole) cannot_read(path, "its PBM header is damaged");
  constexpr Index max_side = Index{1} << 40;
  if (*width < 1 || *height < 1 || *width > max_side || *height > max_side / *width) {
    cannot_read(path,
                fmt::format("its size is {} x {}; expected 1 to 2^40 pixels", *width, *height));
  }
  return {*width, *height, BitOrder::msb_first, *whole};
}

PackedFile::PackedFile(const std::string& path, const PackedFormat& format, int flags)
    : path_(path),
      format_(format),
      descriptor_(::open(path.c_str(), flags | O_CLOEXEC | O_NONBLOCK, 0666)) {
  if (descriptor_ >= 0) return;
  flags == O_RDONLY ? cannot_read_by_errno(path) : cannot_write_by_errno(path);
}

PackedFile PackedFile::open(const std::string& path, const PackedFormat& format) {
  PackedFile file(path, format, O_RDONLY);
  file.check_length();
  return file;
}

PackedFile PackedFile::create(const std::string& path, const PackedFormat& format) {
  PackedFile file(path, format, O_RDWR | O_CREAT | O_TRUNC);
  file.write_bytes(reinterpret_cast<const std::uint8_t*>(format.header.data()),
                   format.header_bytes(), 0);
  if (ftruncate(file.descriptor_, format.file_bytes()) != 0) cannot_write_by_errno(path);
  return file;
}

PackedFile PackedFile::reopen(const std::string& path, const PackedFormat& format) {
  PackedFile file(path, format, O_RDWR);
  file.check_length();
  return file;
}

PackedFile::PackedFile(PackedFile&& other) noexcept
    : path_(std::move(other.path_)),
      format_(std::move(other.format_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

PackedFile& PackedFile::operator=(PackedFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(format_, other.format_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

PackedFile::~PackedFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

void PackedFile::check_length() const {
  struct stat facts {};
  if (fstat(descriptor_, &facts) != 0) cannot_read_by_errno(path_);
  if (!S_ISREG(facts.st_mode)) cannot_read(path_, "it is not a regular file");
  if (facts.st_size == format_.file_bytes()) return;
  cannot_read(path_, fmt::format("it has {} bytes; {}{} x {} pixels take {}", facts.st_size,
                                 format_.header.empty() ? "" : "its header and ", format_.width,
                                 format_.height, format_.file_bytes()));
}

void PackedFile::read_bytes(std::uint8_t* to, Index count, Index offset) const {
  while (count > 0) {
    const ssize_t got = pread(descriptor_, to, static_cast<std::size_t>(count), offset);
    if (got == 0) cannot_read(path_, "the file is truncated");
    if (got < 0 && errno != EINTR) cannot_read_by_errno(path_);
    const Index done = std::max<Index>(got, 0);
    to += done;
    count -= done;
    offset += done;
  }
}

void PackedFile::write_bytes(const std::uint8_t* from, Index count, Index offset) const {
  while (count > 0) {
    const ssize_t put = pwrite(descriptor_, from, static_cast<std::size_t>(count), offset);
    if (put < 0 && errno != EINTR) cannot_write_by_errno(path_);
    const Index done = std::max<Index>(put, 0);
    from += done;
    count -= done;
    offset += done;
  }
}

Index PackedFile::offset_of(const Block& block) const {
  return format_.header_bytes() + block.y * format_.row_bytes() + block.x / 8;
}

bool PackedFile::has_whole_rows(const Block& block) const {
  return block.row_bytes() == format_.row_bytes();
}

void PackedFile::read(const Block& block, std::uint8_t* to) const {
  const Index bytes = block.row_bytes();
  if (has_whole_rows(block)) {
    read_bytes(to, bytes * block.height, offset_of(block));
  } else {
    for (Index y = 0; y < block.height; ++y) {
      read_bytes(to + y * bytes, bytes, offset_of(block) + y * format_.row_bytes());
    }
  }
  const int unused = static_cast<int>(bytes * 8 - block.width);
  if (unused == 0) return;
  const int used = format_.order == BitOrder::msb_first ? 0xFF << unused : 0xFF >> unused;
  for (Index y = 0; y < block.height; ++y) {
    std::uint8_t& last = to[y * bytes + bytes - 1];
    last = static_cast<std::uint8_t>(last & used);
  }
}

void PackedFile::write(const Block& block, const std::uint8_t* from, Index stride) const {
  const Index bytes = block.row_bytes();
  if (has_whole_rows(block) && stride == bytes) {
    write_bytes(from, bytes * block.height, offset_of(block));
    return;
  }
  for (Index y = 0; y < block.height; ++y) {
    write_bytes(from + y * stride, bytes, offset_of(block) + y * format_.row_bytes());
  }
}

void PackedFile::synchronise() const {
  if (fdatasync(descriptor_) != 0) cannot_write_by_errno(path_);
}

Index packed_foreground(const ConstPackedView& image) {
  const Index bytes = packed_row_bytes(image.width);
  Index count = 0;
  for (Index y = 0; y < image.height; ++y) {
    const std::uint8_t* row = image.row(y);
    Index i = 0;
    for (; i + 8 <= bytes; i += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, row + i, sizeof(word));
      count += bits_of(word);
    }
    for (; i < bytes; ++i) count += bits_of(row[i]);
  }
  return count;
}

}  // namespace thinbench
