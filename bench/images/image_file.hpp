// Grey image files. OpenCV decodes and encodes; nothing of it shows here.
#pragma once

#include <stdexcept>
#include <string>

#include "support/byte_image.hpp"

namespace thinbench {

/// Why a image could not be read or written: one line that names the file.
struct ImageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The largest image that is read, in pixels.
inline constexpr Index kMaxImagePixels = Index{1} << 31;

/// The grey levels of a image file of any common format; 16 bits become 8, colours become grey
/// and transparency is ignored. OpenCV reads its own limit of 2^30 pixels from the environment
/// when it is loaded, so that only the user can raise it. Throws ImageError.
[[nodiscard]] ByteImage read_grey(const std::string& path);

/// Writes an 8-bit grey image in the format that the extension names; only formats that keep
/// every pixel are known. The file appears, or is replaced, as a whole or not at all. Throws
/// ImageError.
void write_grey(const std::string& path, const ConstImageView& image);

/// Whether write_grey takes images of this size, which has pixels: below 2^31 of them.
[[nodiscard]] constexpr bool is_writable_size(Index width, Index height) {
  return width <= (kMaxImagePixels - 1) / height;
}

/// Throws ImageError where the extension names no format that write_grey knows.
void check_extension(const std::string& path);

/// The same for images with colours.
void check_colour_extension(const std::string& path);

}  // namespace thinbench
