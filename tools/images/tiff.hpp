// TIFF images, of any kind of samples and of one bit per pixel that stay packed.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "images/codecs.hpp"

namespace thinbench {

/// By its first four bytes.
[[nodiscard]] bool is_tiff(std::string_view bytes);

/// The images of a file, without smaller copies and masks of others; the first one always.
[[nodiscard]] std::vector<int> tiff_pages(std::string_view bytes);

/// Throws DecodeError.
[[nodiscard]] Pixels decode_tiff(std::string_view bytes, const Decoding& request);

/// How an image is written: a value of TIFF's tag each.
struct TiffFormat {
  int compression = 5;  // LZW
  int resolution_unit = 2;
  std::array<float, 2> resolution = {};  // in x and y, per unit; 0 if unknown
};

/// A page of one bit per pixel in strips, of which 1 is bright, and how it was compressed.
struct PackedPage {
  Pixels pixels;
  TiffFormat format;
};

/// The first image, if it has one bit per pixel, black or white, in strips, with the first row on
/// top. Throws FileError where it is damaged.
[[nodiscard]] std::optional<PackedPage> decode_packed_tiff(const FileBytes& file);

/// A file with these pages. Any compression of CCITT becomes that of Group 4, and the old Deflate
/// the new one. Throws std::bad_alloc.
[[nodiscard]] std::string encode_tiff(std::span<const Samples> pages,
                                      const TiffFormat& format = {});

/// Exchanges foreground and background; unused bits become 0.
void invert(const PackedView& image);

}  // namespace thinbench
