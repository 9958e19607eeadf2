#include "images/tiff_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <tiffio.h>

#include "images/open_tiff.hpp"
#include "support/regular_file.hpp"

namespace thinbench {
namespace {

constexpr Index kMaxPixels = Index{1} << 40;
constexpr Index kPartBytes = Index{1} << 18;  // of an image at once, and in strips written
constexpr Index kMaxTileSide = 2048;          // of small images
constexpr Index kCodecBytesPerPixel = 16;     // of a row: lists of runs in CCITT codecs

bool is_known(std::uint16_t compression) {
  return is_ccitt(compression) || compression == COMPRESSION_NONE ||
         compression == COMPRESSION_PACKBITS || compression == COMPRESSION_LZW ||
         compression == COMPRESSION_DEFLATE || compression == COMPRESSION_ADOBE_DEFLATE;
}

/// A lower bound of what rows of so many bytes take where they are compressed, 0 if unknown.
Index min_bytes(std::uint16_t compression, Index bytes, Index rows) {
  switch (compression) {
    case COMPRESSION_NONE:
      return bytes;
    case COMPRESSION_PACKBITS:
      return bytes / 64;  // two bytes stand for up to 128
    case COMPRESSION_LZW:
      return bytes / 4096;  // nine bits for a table's longest text
    case COMPRESSION_DEFLATE:
    case COMPRESSION_ADOBE_DEFLATE:
      return bytes / 1040;  // two bits for up to 258 bytes
    default:
      return is_ccitt(compression) ? rows / 8 : 0;  // a bit for a row like the one before
  }
}

Index min_strip_bytes(const TiffFormat& format, Index rows) {
  return min_bytes(format.compression, rows * format.row_bytes(), rows);
}

bool is_bilevel(const OpenTiff& tiff) {
  const std::uint16_t photometric = tiff.small_number(TIFFTAG_PHOTOMETRIC);
  return TIFFIsTiled(tiff.get()) == 0 && tiff.small_number(TIFFTAG_BITSPERSAMPLE) == 1 &&
         tiff.small_number(TIFFTAG_SAMPLESPERPIXEL) == 1 &&
         (photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE) &&
         tiff.small_number(TIFFTAG_ORIENTATION) == ORIENTATION_TOPLEFT &&
         is_known(tiff.small_number(TIFFTAG_COMPRESSION));
}

TiffFormat format_of(const OpenTiff& tiff) {
  return {tiff.number(TIFFTAG_IMAGEWIDTH),
          tiff.number(TIFFTAG_IMAGELENGTH),
          tiff.small_number(TIFFTAG_COMPRESSION),
          tiff.small_number(TIFFTAG_RESOLUTIONUNIT),
          {tiff.real_number(TIFFTAG_XRESOLUTION), tiff.real_number(TIFFTAG_YRESOLUTION)}};
}

void clear_unused_bits(std::uint8_t* row, Index width) {
  const int unused = static_cast<int>(packed_row_bytes(width) * 8 - width);
  std::uint8_t& last = row[packed_row_bytes(width) - 1];
  last = static_cast<std::uint8_t>(last & 0xFF << unused);
}

}  // namespace

Index TiffFormat::part_rows() const {
  return std::clamp<Index>(kPartBytes / row_bytes(), 1, height);
}

// "m" keeps libtiff from mapping the file: who truncates a mapped file kills its readers.
constexpr const char* kReadMode = "rm";

}  // namespace thinbench

/// In place of libtiff's function of this name, which OpenCV calls: without mapping the file, too.
/// But libtiff 4.5 reads tiles that do not fill kilobytes from mapped files alone.
extern "C" [[gnu::visibility("default")]] TIFF* TIFFOpen(const char* name, const char* mode) {
  TIFF* const tiff = TIFFOpenExt(name, (std::string(mode) + 'm').c_str(), nullptr);
  if (tiff == nullptr || TIFFIsTiled(tiff) == 0) return tiff;
  TIFFClose(tiff);
  return TIFFOpenExt(name, mode, nullptr);
}

namespace thinbench {

bool is_bilevel_tiff(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  const OpenTiff tiff(path, kReadMode);
  return tiff.get() != nullptr && is_bilevel(tiff);
}

bool is_inverted_tiff(const std::string& path) {
  if (!is_tiff(path)) return false;
  const OpenTiff tiff(path, kReadMode);
  return tiff.get() != nullptr && tiff.small_number(TIFFTAG_BITSPERSAMPLE) == 8 &&
         tiff.small_number(TIFFTAG_PHOTOMETRIC) == PHOTOMETRIC_MINISWHITE;
}

bool is_tiff(const std::string& path) {
  const std::string bytes = beginning_of(path, 4);
  using namespace std::string_view_literals;  // the last two are those of BigTIFF
  const std::array marks = {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv};
  return std::find(marks.begin(), marks.end(), bytes) != marks.end();
}

ImageClaim tiff_claim(const std::string& path, int page) {
  const OpenTiff tiff(path, kReadMode);
  if (tiff.get() == nullptr || TIFFSetDirectory(tiff.get(), static_cast<tdir_t>(page)) != 1) {
    return {};
  }
  const Index width = tiff.number(TIFFTAG_IMAGEWIDTH), height = tiff.number(TIFFTAG_IMAGELENGTH);
  const Index tile_width = tiff.number(TIFFTAG_TILEWIDTH), tile = tiff.number(TIFFTAG_TILELENGTH);
  const bool is_large = tile_width > kMaxTileSide || tile > kMaxTileSide;
  if (TIFFIsTiled(tiff.get()) != 0 && is_large && (tile_width > 2 * width || tile > 2 * height)) {
    cannot_read(path, fmt::format("its tiles of {} x {} pixels are larger than its {} x {} pixels",
                                  tile_width, tile, width, height));
  }
  const Index bits =
      Index{tiff.small_number(TIFFTAG_BITSPERSAMPLE)} * tiff.small_number(TIFFTAG_SAMPLESPERPIXEL);
  if (width > kMaxPixels / std::max<Index>(1, height)) return {width, height, 0};
  const Index bytes = height * ((width * bits + 7) / 8);
  return {width, height, min_bytes(tiff.small_number(TIFFTAG_COMPRESSION), bytes, height)};
}

std::string unreadable_tiff_reason(const std::string& path) {
  const OpenTiff tiff(path, kReadMode);
  if (tiff.get() == nullptr) return {};
  const int bits = tiff.small_number(TIFFTAG_BITSPERSAMPLE);
  const bool is_integer = tiff.small_number(TIFFTAG_SAMPLEFORMAT) == SAMPLEFORMAT_UINT;
  if (is_integer && (bits == 1 || bits == 8 || bits == 16)) return {};
  return fmt::format("its samples have {} bits{}; known are integers of 1, 8 and 16 bits", bits,
                     is_integer ? "" : " and are no unsigned integers");
}

TiffReader::TiffReader(const std::string& path) : path_(path) {
  check_file(path);
  tiff_ = std::make_unique<OpenTiff>(path, kReadMode);
  if (tiff_->get() == nullptr) cannot_read(path, tiff_->complaint());
  if (!is_bilevel(*tiff_)) cannot_read(path, "it is not a TIFF image of 1 bit per pixel in strips");
  format_ = format_of(*tiff_);
  is_inverted_ = tiff_->small_number(TIFFTAG_PHOTOMETRIC) == PHOTOMETRIC_MINISWHITE;
  if (format_.width < 1 || format_.height < 1 || format_.height > kMaxPixels / format_.width) {
    cannot_read(path, fmt::format("its size is {} x {}; expected 1 to 2^40 pixels", format_.width,
                                  format_.height));
  }
  check_strips();
}

TiffReader::~TiffReader() = default;

void TiffReader::check_strips() const {
  const Index rows_per_strip = std::min(format_.height, tiff_->number(TIFFTAG_ROWSPERSTRIP));
  const auto file_bytes = static_cast<std::uint64_t>(file_size_or_0(path_));
  for (std::uint32_t strip = 0; strip < TIFFNumberOfStrips(tiff_->get()); ++strip) {
    const std::uint64_t offset = TIFFGetStrileOffset(tiff_->get(), strip);
    const std::uint64_t bytes = TIFFGetStrileByteCount(tiff_->get(), strip);
    if (offset > file_bytes || bytes > file_bytes - offset) {
      cannot_read(path_, "the file is truncated");
    }
    const Index rows = std::min(rows_per_strip, format_.height - strip * rows_per_strip);
    if (static_cast<Index>(bytes) >= min_strip_bytes(format_, rows)) continue;
    cannot_read(path_, fmt::format("its strips are too short for {} x {} pixels", format_.width,
                                   format_.height));
  }
}

Index TiffReader::working_bytes() const {
  std::uint64_t strip_bytes = 0;
  for (std::uint32_t strip = 0; strip < TIFFNumberOfStrips(tiff_->get()); ++strip) {
    strip_bytes = std::max(strip_bytes, TIFFGetStrileByteCount(tiff_->get(), strip));
  }
  const Index row = is_ccitt(format_.compression) ? kCodecBytesPerPixel * format_.width : 0;
  return static_cast<Index>(strip_bytes) + row + format_.part_rows() * format_.row_bytes();
}

void TiffReader::read(Index rows, std::uint8_t* to) {
  for (const Index end = next_ + rows; next_ < end; ++next_, to += format_.row_bytes()) {
    const int status = TIFFReadScanline(tiff_->get(), to, static_cast<std::uint32_t>(next_));
    if (!tiff_->complaint().empty()) cannot_read(path_, tiff_->complaint());
    if (status < 0) cannot_read(path_, "it is damaged");
    if (is_inverted_) {
      invert({to, format_.width, 1, BitOrder::msb_first});
    } else {
      clear_unused_bits(to, format_.width);
    }
  }
}

void read_tiff(const std::string& path,
               const std::function<void(const PackedView& rows, Index y)>& use) {
  TiffReader reader(path);
  const TiffFormat& format = reader.format();
  const Index part = format.part_rows();
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(part * format.row_bytes()));
  for (Index y = 0; y < format.height; y += part) {
    const Index rows = std::min(part, format.height - y);
    reader.read(rows, bytes.data());
    use({bytes.data(), format.width, rows, BitOrder::msb_first}, y);
  }
}

void invert(const PackedView& image) {
  const Index bytes = packed_row_bytes(image.width);
  for (Index y = 0; y < image.height; ++y) {
    std::uint8_t* const row = image.data + y * image.stride;
    std::transform(row, row + bytes, row,
                   [](std::uint8_t byte) { return static_cast<std::uint8_t>(~byte); });
    clear_unused_bits(row, image.width);
  }
}

}  // namespace thinbench
