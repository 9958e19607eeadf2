// TIFF images, written row by row, and those of one bit per pixel in strips read so, too. libtiff
// decodes and encodes; nothing of it shows here.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "images/image_file.hpp"
#include "images/image_header.hpp"
#include "thinbench/packed.hpp"

namespace thinbench {

struct TiffFormat {
  Index width = 0;
  Index height = 0;
  std::uint16_t compression = 1;  // the value of TIFF's tag
  std::uint16_t resolution_unit = 2;
  std::array<float, 2> resolution = {};  // in x and y, per unit; 0 if unknown
  int bits = 1;                          // of a sample: 1, or 8 in what is written
  int samples = 1;                       // of a pixel: 3 are red, green, blue

  [[nodiscard]] Index row_bytes() const { return packed_row_bytes(width * bits * samples); }
  /// How many rows are read or written at once: about 256 KiB.
  [[nodiscard]] Index part_rows() const;
};

/// By its first four bytes. Throws FileError.
[[nodiscard]] bool is_tiff(const std::string& path);

/// Of one image of a TIFF file, counted from 0. Throws FileError for tiles that take far more
/// memory than the image.
[[nodiscard]] ImageClaim tiff_claim(const std::string& path, int page);

/// Whether the first image of a file is one that TiffReader reads, though perhaps damaged: of one
/// bit per pixel, black or white, in strips, with the first row on top, and uncompressed or with
/// PackBits, LZW, Deflate or CCITT compression. False for files that cannot be read.
[[nodiscard]] bool is_bilevel_tiff(const std::string& path);

/// Whether it has 8 bits per sample of which 0 is white, so that its levels are read as 255 minus
/// what is stored.
[[nodiscard]] bool is_inverted_tiff(const std::string& path);

/// Why image decoders reject a TIFF file that may be in order: the kind of its samples. Empty if
/// there is no such reason.
[[nodiscard]] std::string unreadable_tiff_reason(const std::string& path);

class OpenTiff;

/// The rows of the first image of a file, one after another. Errors are FileError: one line that
/// names the file. What the decoder warns of is an error, too.
class TiffReader {
 public:
  /// Rejects what is_bilevel_tiff does not accept, more than 2^40 pixels, and images whose strips
  /// do not lie in the file or are too short for them.
  explicit TiffReader(const std::string& path);
  ~TiffReader();
  TiffReader(const TiffReader&) = delete;
  TiffReader& operator=(const TiffReader&) = delete;

  [[nodiscard]] const TiffFormat& format() const { return format_; }
  /// The memory that reading takes, in bytes, at most: a compressed strip and a few rows.
  [[nodiscard]] Index working_bytes() const;

  /// Reads the next rows without gaps, most significant bit first. 1 is bright; unused bits are 0.
  void read(Index rows, std::uint8_t* to);

 private:
  void check_strips() const;

  std::string path_;
  std::unique_ptr<OpenTiff> tiff_;
  TiffFormat format_;
  bool is_inverted_ = false;  // in the file, 0 is bright
  Index next_ = 0;            // row
};

/// Calls `use` with all rows of an image, a part at a time, and the number of the first.
void read_tiff(const std::string& path,
               const std::function<void(const PackedView& rows, Index y)>& use);

/// Writes images to the file `name` row by row, in which 1 is bright. The format's compression is
/// kept, but any of CCITT becomes that of Group 4, and the old Deflate the new one. `path` is the
/// file that messages name. Errors are FileError.
class TiffWriter {
 public:
  /// Begins with the first image; `bytes` are those of the pixels of all, if there are several.
  TiffWriter(const std::string& name, std::string path, const TiffFormat& format, Index bytes = 0);
  ~TiffWriter();
  TiffWriter(const TiffWriter&) = delete;
  TiffWriter& operator=(const TiffWriter&) = delete;

  /// Appends rows without gaps, most significant bit first.
  void write(Index rows, const std::uint8_t* from);
  /// Begins the next image, after the last row of the one before.
  void begin_page(const TiffFormat& format);
  /// Ends the file. Must be called after the last row.
  void finish();

 private:
  void set_tags(const TiffFormat& format);
  void check(bool is_written) const;

  std::string path_;
  std::unique_ptr<OpenTiff> tiff_;
  Index row_bytes_ = 0;
  Index next_ = 0;
};

/// Exchanges foreground and background; unused bits become 0.
void invert(const PackedView& image);

}  // namespace thinbench
