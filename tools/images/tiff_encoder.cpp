#include <algorithm>

#include "images/tiff.hpp"
#include "images/tiff_handle.hpp"

namespace thinbench {
namespace {

constexpr Index kBigTiffBytes = Index{1} << 30;  // from here on: offsets of 64 bits
constexpr Index kStripBytes = Index{1} << 18;    // about, of pixels

int written_compression(int compression) {
  if (compression == COMPRESSION_DEFLATE) return COMPRESSION_ADOBE_DEFLATE;
  return is_ccitt(compression) ? COMPRESSION_CCITTFAX4 : compression;
}

void set_tags(TIFF* tiff, const Samples& page, const TiffFormat& format) {
  const bool is_bit = page.kind == SampleKind::bit;
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(page.width));
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(page.height));
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE,
               is_bit ? 1 : static_cast<int>(8 * sample_bytes(page.kind)));
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, page.channels);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC,
               page.channels == 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  if (page.kind == SampleKind::f32) TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, written_compression(format.compression));
  TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP,
               static_cast<std::uint32_t>(
                   std::clamp<Index>(kStripBytes / page.row_bytes(), 1, page.height)));
  if (format.resolution[0] <= 0 || format.resolution[1] <= 0) return;
  TIFFSetField(tiff, TIFFTAG_XRESOLUTION, static_cast<double>(format.resolution[0]));
  TIFFSetField(tiff, TIFFTAG_YRESOLUTION, static_cast<double>(format.resolution[1]));
  TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, format.resolution_unit);
}

}  // namespace

std::string encode_tiff(std::span<const Samples> pages, const TiffFormat& format) {
  Index bytes = 0;
  for (const Samples& page : pages) bytes += page.row_bytes() * page.height;
  TiffHandle file(bytes >= kBigTiffBytes ? "w8" : "w");
  for (const Samples& page : pages) {
    if (file.get() == nullptr) throw std::bad_alloc();
    set_tags(file.get(), page, format);
    for (Index y = 0; y < page.height; ++y) {
      auto* const row = const_cast<std::uint8_t*>(page.row(y));  // changed where bytes are swapped
      if (TIFFWriteScanline(file.get(), row, static_cast<std::uint32_t>(y)) < 0)
        throw std::bad_alloc();
    }
    if (pages.size() > 1 && TIFFWriteDirectory(file.get()) != 1) throw std::bad_alloc();
  }
  return file.take();
}

}  // namespace thinbench
