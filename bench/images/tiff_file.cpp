#include "images/tiff_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <tiffio.h>

#include "support/text.hpp"

namespace thinbench {
namespace {

constexpr Index kMaxPixels = Index{1} << 40;
constexpr Index kPartBytes = Index{1} << 18;     // of an image at once, and in strips written
constexpr Index kBigTiffBytes = Index{1} << 30;  // from here on: offsets of 64 bits
constexpr Index kCodecBytes = Index{1} << 28;    // for lists of a row, at most
constexpr Index kCodecBytesPerPixel = 16;        // of a row: lists of runs in CCITT codecs

[[noreturn]] void cannot_read(const std::string& path, const std::string& why) {
  throw ImageError("cannot read '" + path + "': " + why);
}

Index size_of(const std::string& path) {
  std::error_code ignored;
  return static_cast<Index>(std::filesystem::file_size(path, ignored));
}

bool is_ccitt(std::uint16_t compression) {
  return compression == COMPRESSION_CCITTRLE || compression == COMPRESSION_CCITTRLEW ||
         compression == COMPRESSION_CCITTFAX3 || compression == COMPRESSION_CCITTFAX4;
}

bool is_known(std::uint16_t compression) {
  return is_ccitt(compression) || compression == COMPRESSION_NONE ||
         compression == COMPRESSION_PACKBITS || compression == COMPRESSION_LZW ||
         compression == COMPRESSION_DEFLATE || compression == COMPRESSION_ADOBE_DEFLATE;
}

/// The compression of the output: that of the input, or its successor.
int written_compression(std::uint16_t compression) {
  if (compression == COMPRESSION_DEFLATE) return COMPRESSION_ADOBE_DEFLATE;
  return is_ccitt(compression) ? COMPRESSION_CCITTFAX4 : compression;
}

/// A lower bound of the bytes that a strip of so many rows takes.
Index min_strip_bytes(const TiffFormat& format, Index rows) {
  const Index bytes = rows * format.row_bytes();
  switch (format.compression) {
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
      return rows / 8;  // a bit for a row like the one before
  }
}

}  // namespace

/// A file that libtiff has open, and the first thing that it complained of.
class OpenTiff {
 public:
  OpenTiff(const std::string& path, const char* mode) {
    TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
    TIFFOpenOptionsSetMaxSingleMemAlloc(options, 2 * size_of(path) + kCodecBytes);
    TIFFOpenOptionsSetErrorHandlerExtR(options, keep_complaint, this);
    TIFFOpenOptionsSetWarningHandlerExtR(options, keep_warning, this);
    tiff_ = TIFFOpenExt(path.c_str(), mode, options);
    TIFFOpenOptionsFree(options);
    warnings_count_ = true;
  }
  ~OpenTiff() {
    if (tiff_ != nullptr) TIFFClose(tiff_);
  }
  OpenTiff(const OpenTiff&) = delete;
  OpenTiff& operator=(const OpenTiff&) = delete;

  /// Null if the file could not be opened.
  [[nodiscard]] TIFF* get() const { return tiff_; }
  /// Empty if there is none. Warnings count only once the file is open: before, they tell of tags.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }

  /// The value of a tag, else its default; kNone and 0 if it has none.
  static constexpr std::uint16_t kNone = 0xFFFF;
  [[nodiscard]] std::uint16_t small_number(std::uint32_t tag) const {
    std::uint16_t value = kNone;
    TIFFGetFieldDefaulted(tiff_, tag, &value);
    return value;
  }
  [[nodiscard]] Index number(std::uint32_t tag) const {
    std::uint32_t value = 0;
    TIFFGetFieldDefaulted(tiff_, tag, &value);
    return value;
  }
  [[nodiscard]] float real_number(std::uint32_t tag) const {
    float value = 0;
    return TIFFGetField(tiff_, tag, &value) == 1 ? value : 0;
  }

 private:
  static int keep_complaint(TIFF* /*tiff*/, void* self, const char* /*function*/,
                            const char* format, std::va_list values) {
    std::array<char, 400> text{};
    static_cast<void>(std::vsnprintf(text.data(), text.size(), format, values));
    std::string& complaint = static_cast<OpenTiff*>(self)->complaint_;
    if (complaint.empty()) complaint = one_line(text.data());
    if (complaint.ends_with('.')) complaint.pop_back();
    return 1;  // libtiff prints nothing
  }
  static int keep_warning(TIFF* tiff, void* self, const char* function, const char* format,
                          std::va_list values) {
    const bool counts = static_cast<OpenTiff*>(self)->warnings_count_;
    return counts ? keep_complaint(tiff, self, function, format, values) : 1;
  }

  TIFF* tiff_ = nullptr;
  std::string complaint_;
  bool warnings_count_ = false;
};

namespace {

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

bool is_bilevel_tiff(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  const OpenTiff tiff(path, kReadMode);
  return tiff.get() != nullptr && is_bilevel(tiff);
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
  const auto file_bytes = static_cast<std::uint64_t>(size_of(path_));
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

TiffWriter::TiffWriter(const std::string& name, std::string path, const TiffFormat& format)
    : path_(std::move(path)), row_bytes_(format.row_bytes()) {
  errno = 0;
  const bool is_big = row_bytes_ * format.height >= kBigTiffBytes;
  tiff_ = std::make_unique<OpenTiff>(name, is_big ? "w8" : "w");
  check(tiff_->get() != nullptr);
  set_tags(format);
}

TiffWriter::~TiffWriter() = default;

void TiffWriter::set_tags(const TiffFormat& format) {
  TIFF* const tiff = tiff_->get();
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(format.width));
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(format.height));
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
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
  throw ImageError("cannot write '" + path_ + "': " + why);
}

void TiffWriter::write(Index rows, const std::uint8_t* from) {
  errno = 0;
  for (Index y = 0; y < rows; ++y, ++next_, from += row_bytes_) {
    auto* const row = const_cast<std::uint8_t*>(from);  // changed for wider samples alone
    check(TIFFWriteScanline(tiff_->get(), row, static_cast<std::uint32_t>(next_)) >= 0);
  }
}

void TiffWriter::finish() {
  errno = 0;
  check(TIFFFlush(tiff_->get()) == 1);
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
