// Grey pictures in files. OpenCV decodes and encodes; nothing of it shows here.
#pragma once

#include <stdexcept>
#include <string>

#include "support/byte_image.hpp"

namespace thinbench {

/// Why a picture could not be read or written: one line that names the file.
struct PictureError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The largest picture that is read, in pixels.
inline constexpr Index kMaxPicturePixels = Index{1} << 31;

/// The grey levels of a picture file of any common format; 16 bits become 8, colours become grey
/// and transparency is left out. OpenCV reads its own limit of 2^30 pixels from the environment
/// when it is loaded, so that only the user can raise it. Throws PictureError.
[[nodiscard]] ByteImage read_grey(const std::string& path);

/// Writes an 8-bit grey picture in the format that the extension names; only formats that keep
/// every pixel are known. The file appears, or is replaced, as a whole or not at all. Throws
/// PictureError.
void write_grey(const std::string& path, const ConstImageView& picture);

/// Whether write_grey takes pictures of this size, which has pixels: below 2^31 of them.
[[nodiscard]] constexpr bool is_writable_size(Index width, Index height) {
  return width <= (kMaxPicturePixels - 1) / height;
}

/// Throws PictureError where the extension names no format that write_grey knows.
void check_extension(const std::string& path);

/// The same for pictures with colours.
void check_colour_extension(const std::string& path);

}  // namespace thinbench
