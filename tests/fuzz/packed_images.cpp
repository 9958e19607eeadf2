// Packed images in PBM files and TIFF files of one bit per pixel: all rows, or one line that says
// what is wrong.
#include <vector>

#include "images/packed_file.hpp"
#include "images/tiff_file.hpp"
#include "memory_file.hpp"

namespace thinbench {
namespace {

void read_pbm(const std::string& path) {
  const PackedFormat format = pbm_format(path);
  const PackedFile file = PackedFile::open(path, format);
  std::vector<std::uint8_t> rows(static_cast<std::size_t>(format.row_bytes() * format.height));
  file.read({0, 0, format.width, format.height}, rows.data());
  static_cast<void>(packed_foreground({rows.data(), format.width, format.height, format.order}));
}

void read_tiff_rows(const std::string& path) {
  static_cast<void>(unreadable_tiff_reason(path));
  const bool is_bilevel = is_bilevel_tiff(path);
  constexpr Index max_pixels = Index{1} << 22;
  {
    const TiffReader reader(path);
    must(is_bilevel, "a file is read that is none of one bit per pixel");
    must(reader.working_bytes() > 0, "reading takes no memory");
    const TiffFormat& format = reader.format();
    if (format.height > max_pixels / format.width) return;  // takes too long
  }
  Index next = 0;
  read_tiff(path, [&](const PackedView& rows, Index y) {
    must(y == next, "rows are missing");
    next += rows.height;
    static_cast<void>(packed_foreground(rows));
  });
}

}  // namespace

void try_input(ByteSource& input) {
  static const MemoryFile file;
  const bool is_empty = input.is_empty();
  file.hold(input.take(SIZE_MAX));
  must_succeed_or_explain<FileError>([] { read_pbm(file.path()); });
  if (is_empty) return;
  must_succeed_or_explain<FileError>([] { read_tiff_rows(file.path()); });
}

}  // namespace thinbench
