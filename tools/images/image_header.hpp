// What the beginning of an image file claims, compared with the length of the file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "thinbench/image_view.hpp"

namespace thinbench {

/// The size that a header names, 0 where it is damaged, and the least bytes that so many pixels
/// take in a file of this kind.
struct ImageClaim {
  Index width = 0;
  Index height = 0;
  Index min_bytes = 0;
};

/// Rejects, before memory is taken for pixels, files of other kinds than PNG, JPEG, TIFF, BMP and
/// PNM, and those that are too short for the size that their header names: files of a few bytes
/// could claim gigabytes. `page` counts the images of a TIFF file from 0. Damaged headers are left
/// to the decoder. For regular files; throws FileError.
void check_header(const std::string& path, int page);

/// Rejects regular files whose levels the decoder stretches to 8 bits, which changes numbers.
/// Throws FileError.
void check_label_levels(const std::string& path);

/// The grey level, or blue, green and red, of pixels that are transparent.
using TransparentColour = std::vector<double>;

/// Nothing where all pixels of a file are opaque: it is not PNG, or has neither a channel of
/// opacity nor a chunk of transparent colours. Empty where the decoder gives the opacity.
[[nodiscard]] std::optional<TransparentColour> png_transparency(const std::string& path);

}  // namespace thinbench
