// TIFF files of tests.
#pragma once

#include <cstdint>
#include <string>

#include <gtest/gtest.h>
#include <tiffio.h>

#include "support/packed_image.hpp"

namespace thinbench {

struct TiffKind {
  std::uint16_t compression = COMPRESSION_NONE;
  std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
  std::uint16_t fill_order = FILLORDER_MSB2LSB;
  std::uint32_t rows_per_strip = 7;
  std::uint16_t orientation = ORIENTATION_TOPLEFT;
  std::uint32_t tile = 0;  // the side of tiles, instead of strips
};

/// Writes an image, by libtiff, in which pixels other than 0 are bright. Unused bits are not 0.
inline void write_tiff(const std::string& path, const ConstImageView& image, const TiffKind& kind) {
  ByteImage bits(image.width, image.height);
  const bool inverted = kind.photometric == PHOTOMETRIC_MINISWHITE;
  for (Index y = 0; y < image.height; ++y) {
    for (Index x = 0; x < image.width; ++x) bits.at(x, y) = (image.row(y)[x] != 0) != inverted;
  }
  PackedImage packed(bits.view(), BitOrder::msb_first, 0, 0xFF);
  TIFF* const tiff = TIFFOpen(path.c_str(), "w");
  ASSERT_NE(tiff, nullptr);
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(image.width));
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(image.height));
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, kind.photometric);
  TIFFSetField(tiff, TIFFTAG_FILLORDER, kind.fill_order);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, kind.compression);
  TIFFSetField(tiff, TIFFTAG_ORIENTATION, kind.orientation);
  TIFFSetField(tiff, TIFFTAG_XRESOLUTION, 204.0);
  TIFFSetField(tiff, TIFFTAG_YRESOLUTION, 98.0);
  if (kind.tile > 0) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, kind.tile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, kind.tile);
    std::string tile(kind.tile * kind.tile / 8, '\x33');
    for (std::uint32_t i = 0; i < TIFFNumberOfTiles(tiff); ++i) {
      TIFFWriteEncodedTile(tiff, i, tile.data(), static_cast<tmsize_t>(tile.size()));
    }
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, kind.rows_per_strip);
    for (Index y = 0; y < image.height; ++y) {
      ASSERT_EQ(TIFFWriteScanline(tiff, packed.view().data + y * packed.view().stride,
                                  static_cast<std::uint32_t>(y)),
                1);
    }
  }
  TIFFClose(tiff);
}

/// A tag of one number, as the file has it; 0 if it has none.
inline int tiff_tag(const std::string& path, std::uint32_t tag) {
  TIFF* const tiff = TIFFOpen(path.c_str(), "r");
  std::uint16_t value = 0;
  if (tiff != nullptr) TIFFGetField(tiff, tag, &value);
  if (tiff != nullptr) TIFFClose(tiff);
  return value;
}

/// A TIFF file of these bytes in one strip, made byte by byte: an oracle that needs no library.
inline std::string plain_tiff(std::uint32_t width, std::uint32_t height, int photometric,
                              int fill_order, const std::string& rows,
                              int compression = COMPRESSION_NONE) {
  std::string bytes("II*\0\x08\0\0\0", 8);
  const auto add = [&](std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> 8 * i & 0xFF);
  };
  struct Tag {
    int number;
    int type;  // 3: 16 bits, 4: 32 bits
    std::uint32_t value;
  };
  constexpr std::uint32_t kStart = 8 + 2 + 9 * 12 + 4;
  const Tag tags[] = {{256, 4, width},
                      {257, 4, height},
                      {258, 3, 1},
                      {259, 3, static_cast<std::uint32_t>(compression)},
                      {262, 3, static_cast<std::uint32_t>(photometric)},
                      {266, 3, static_cast<std::uint32_t>(fill_order)},
                      {273, 4, kStart},
                      {278, 4, height},
                      {279, 4, static_cast<std::uint32_t>(rows.size())}};
  add(9, 2);
  for (const Tag& tag : tags) {
    add(static_cast<std::uint32_t>(tag.number), 2);
    add(static_cast<std::uint32_t>(tag.type), 2);
    add(1, 4);
    add(tag.value, 4);
  }
  add(0, 4);
  return bytes + rows;
}

}  // namespace thinbench
