// Image files as bytes: decoding of every format that is read, encoding of those that are written.
#pragma once

#include <cstdint>
#include <new>
#include <string>
#include <string_view>

#include "images/pixels.hpp"
#include "support/file_bytes.hpp"
#include "support/text.hpp"

namespace thinbench {

struct Decoding {
  int page = 0;            // of a TIFF file
  bool as_stored = false;  // numbers, not levels: of a palette the indices, of few bits no scaling
  bool lenient = false;    // damaged JPEG and TIFF as far as possible, with a warning
};

/// Grey levels or colours; 8 bits from 0 to 255, more bits as they are. Throws FileError with the
/// reason where the bytes are no image of a known format, damaged, or too few for the size that
/// they claim; then no memory was taken.
[[nodiscard]] Pixels decode(const FileBytes& file, const Decoding& request = {});

/// Calls decode(), whose errors become a FileError that names the file.
template <class Decode>
auto naming(const FileBytes& file, const Decode& decode) {
  try {
    return decode();
  } catch (const DecodeError& error) {
    cannot_read(file.name(), one_line(error.what()));
  } catch (const std::bad_alloc&) {
    cannot_read(file.name(), "there is not enough memory for it");
  }
}

[[nodiscard]] inline bool is_tiff_extension(std::string_view extension) {
  return extension == ".tif" || extension == ".tiff";
}

/// The images of a TIFF file, counted from 0, without smaller copies and masks of others; {0} of
/// all other files.
[[nodiscard]] std::vector<int> pages_in(const FileBytes& file);

/// An image to encode: `stride` in bytes; 1 or 3 channels.
struct Samples {
  const void* data;
  Index width;
  Index height;
  Index stride;
  int channels = 1;
  SampleKind kind = SampleKind::u8;

  [[nodiscard]] const std::uint8_t* row(Index y) const {
    return static_cast<const std::uint8_t*>(data) + y * stride;
  }
  /// Without gaps, and without the alignment of the stride.
  [[nodiscard]] Index row_bytes() const {
    return kind == SampleKind::bit ? packed_row_bytes(width)
                                   : width * channels * sample_bytes(kind);
  }
};

// Each decodes one format; errors are DecodeError.
[[nodiscard]] Pixels decode_png(std::string_view bytes, const Decoding& request);
[[nodiscard]] Pixels decode_jpeg(std::string_view bytes, const Decoding& request);
[[nodiscard]] Pixels decode_bmp(std::string_view bytes, const Decoding& request);
[[nodiscard]] Pixels decode_pnm(std::string_view bytes, const Decoding& request);

/// All bytes of a file. Throws std::bad_alloc.
[[nodiscard]] std::string encode_png(const Samples& image);
[[nodiscard]] std::string encode_bmp(const Samples& image);
[[nodiscard]] std::string encode_pgm(const Samples& image);
[[nodiscard]] std::string encode_pbm(const Samples& image);  // of 0 and 255

/// Numbers of formats in which the lowest byte comes first.
[[nodiscard]] inline std::uint32_t little_endian(std::string_view bytes, std::size_t at,
                                                 std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = count; i > 0; --i) {
    value =
        value << 8 | (at + i <= bytes.size() ? static_cast<std::uint8_t>(bytes[at + i - 1]) : 0U);
  }
  return value;
}

}  // namespace thinbench
