// Image files written, images of labels and grey ones read.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "images/codecs.hpp"
#include "support/byte_image.hpp"

namespace thinbench {

/// Labels of pixels in rows without gaps; 0 is background.
struct LabelPixels {
  Index width = 0;
  Index height = 0;
  std::vector<std::int32_t> labels;
  std::optional<GeoReference> place = std::nullopt;

  [[nodiscard]] ConstLabelView view() const { return {labels.data(), width, height}; }
  [[nodiscard]] LabelView view() { return {labels.data(), width, height}; }
};

/// The numbers of the pixels of an image with one channel of integers, such as write_labels makes,
/// or with a palette. Throws FileError.
[[nodiscard]] LabelPixels read_labels(const FileBytes& file);

/// The grey levels of an image, in 8 bits; of a TIFF file the page, counted from 0. Throws
/// FileError.
[[nodiscard]] ByteImage read_grey(const std::string& path, int page = 0);

/// A file, which appears as a whole or not at all, or "-". Throws FileError.
void write_bytes(const std::string& path, std::string_view bytes);

/// Writes images of 8 bits, all with one size, in the format that the extension names; only formats
/// that keep every pixel are known, and TIFF alone holds several. The file appears, or is replaced,
/// as a whole or not at all; "-" is PNG on standard output. Throws FileError.
void write_grey(const std::string& path, const ConstImageView& image);
void write_grey_pages(const std::string& path, const std::vector<ByteImage>& pages);

/// The same for an image of 0 and 255 alone; .pbm is known, too.
void write_binary(const std::string& path, const ConstImageView& image);

/// The same for red, green and blue in three bytes a pixel, without gaps.
void write_colours(const std::string& path, const std::vector<std::uint8_t>& colours, Index width,
                   Index height);

/// The same with 16 bits per pixel, in PNG, PGM or TIFF.
void write_deep(const std::string& path, const View<const std::uint16_t>& image);

/// The same with 16 bits or, where a label needs more, 32 bits in TIFF.
void write_labels(const std::string& path, const ConstLabelView& labels);

/// Real numbers of 32 bits, in TIFF.
void write_reals(const std::string& path, const View<const float>& image);

/// The bytes of a PNG file. Throws FileError.
[[nodiscard]] std::string png_of(const ConstImageView& image);

/// The name of an image to write has an extension that stands for no format.
struct ExtensionError : FileError {
  using FileError::FileError;
};

// Each throws ExtensionError where the extension names no format that can hold the image: grey
// levels, 16 bits, colours or SVG, real numbers.
void check_extension(const std::string& path);
void check_deep_extension(const std::string& path);
void check_overlay_extension(const std::string& path);
void check_real_extension(const std::string& path);

}  // namespace thinbench
