// Packed images in PBM files and TIFF files of one bit per pixel: all rows, or one line that says
// what is wrong.
#include "byte_source.hpp"
#include "images/binarise.hpp"
#include "images/pnm.hpp"
#include "images/tiff.hpp"

namespace thinbench {
namespace {

void read_tiff_rows(const FileBytes& file) {
  const auto page = decode_packed_tiff(file);
  if (!page) return;
  const Pixels& rows = page->pixels;
  static_cast<void>(packed_foreground({rows.row(0), rows.width, rows.height, BitOrder::msb_first}));
}

}  // namespace

void try_input(ByteSource& input) {
  const auto bytes = input.take(SIZE_MAX);
  const FileBytes file("input", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  must_succeed_or_explain<FileError>([&] { must(pbm_format(file).width > 0, "no pixels"); });
  must_succeed_or_explain<FileError>([&] { read_tiff_rows(file); });
}

}  // namespace thinbench
