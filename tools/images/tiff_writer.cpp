#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "images/open_tiff.hpp"
#include "images/tiff_file.hpp"

namespace thinbench {
namespace {

constexpr Index kBigTiffBytes = Index{1} << 30;  // from here on: offsets of 64 bits

/// The compression of the output: that of the input, or its successor.
int written_compression(std::uint16_t compression) {
  if (compression == COMPRESSION_DEFLATE) return COMPRESSION_ADOBE_DEFLATE;
  return is_ccitt(compression) ? COMPRESSION_CCITTFAX4 : compression;
}

}  // namespace

TiffWriter::TiffWriter(const std::string& name, std::string path, const TiffFormat& format,
                       Index bytes)
    : path_(std::move(path)) {
  errno = 0;
  const bool is_big = std::max(bytes, format.row_bytes() * format.height) >= kBigTiffBytes;
  tiff_ = std::make_unique<OpenTiff>(name, is_big ? "w8" : "w");
  check(tiff_->get() != nullptr);
  set_tags(format);
}

TiffWriter::~TiffWriter() = default;

void TiffWriter::set_tags(const TiffFormat& format) {
  TIFF* const tiff = tiff_->get();
  row_bytes_ = format.row_bytes();
  next_ = 0;
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(format.width));
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(format.height));
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, format.bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, format.samples);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC,
               format.samples == 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, written_compression(format.compression));
  TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(format.part_rows()));
  if (format.resolution[0] <= 0 || format.resolution[1] <= 0) return;
  TIFFSetField(tiff, TIFFTAG_XRESOLUTION, static_cast<double>(format.resolution[0]));
  TIFFSetField(tiff, TIFFTAG_YRESOLUTION, static_cast<double>(format.resolution[1]));
  TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, static_cast<int>(format.resolution_unit));
}

/// libtiff says that writing failed, the system why.
void TiffWriter::check(bool is_written) const {
  if (is_written && tiff_->complaint().empty()) return;
  const std::string why = errno != 0 ? std::generic_category().message(errno) : tiff_->complaint();
  cannot_write(path_, why);
}

void TiffWriter::write(Index rows, const std::uint8_t* from) {
  errno = 0;
  for (Index y = 0; y < rows; ++y, ++next_, from += row_bytes_) {
    auto* const row = const_cast<std::uint8_t*>(from);  // changed for wider samples alone
    check(TIFFWriteScanline(tiff_->get(), row, static_cast<std::uint32_t>(next_)) >= 0);
  }
}

void TiffWriter::begin_page(const TiffFormat& format) {
  errno = 0;
  check(TIFFWriteDirectory(tiff_->get()) == 1);
  set_tags(format);
}

void TiffWriter::finish() {
  errno = 0;
  check(TIFFFlush(tiff_->get()) == 1);
}

}  // namespace thinbench
