// Grey image files. OpenCV decodes and encodes; nothing of it shows here.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/byte_image.hpp"
#include "support/file_error.hpp"
#include "thinbench/binarise.hpp"

namespace thinbench {

/// The largest image that is read, in pixels.
inline constexpr Index kMaxImagePixels = Index{1} << 31;

/// The path "-" stands for standard input where an image is read, and for PNG on standard output
/// where one is written.
inline constexpr const char* kStandardStream = "-";

/// Calls `read` with the path of a copy of standard input, which errors do not name.
void read_standard_input(const std::function<void(const std::string& copy)>& read);

/// Rejects what no decoder could give a good reason for: no such file, a directory, an empty file.
/// Throws FileError.
void check_file(const std::string& path);

/// The grey levels of an image file of any common format; 16 bits become 8, colours become grey
/// as by select_channel, and transparency is ignored. OpenCV reads its own limit of 2^30 pixels
/// from the environment when it is loaded, so that only the user can raise it. A JPEG file of which
/// the decoder says that it is corrupt or truncated is an error; where `warning` is given, it is
/// read as far as possible, and what the decoder says goes there. Throws FileError.
[[nodiscard]] ByteImage read_grey(const std::string& path, std::string* warning = nullptr);

/// As read_grey, by this channel, which becomes the one that was chosen: of a page of a TIFF file,
/// counted from 0, or of the only image. Colours take 3 bytes per pixel more.
[[nodiscard]] ByteImage read_channel(const std::string& path, std::optional<int> page,
                                     Channel& channel, std::string* warning = nullptr);

/// Labels of pixels in rows without gaps; 0 is background.
struct LabelPixels {
  Index width = 0;
  Index height = 0;
  std::vector<std::int32_t> labels;

  [[nodiscard]] ConstLabelView view() const { return {labels.data(), width, height}; }
  [[nodiscard]] LabelView view() { return {labels.data(), width, height}; }
};

/// The numbers of the pixels of an image file with one channel of 8 or 16 bits, such as write_deep
/// makes. Throws FileError.
[[nodiscard]] LabelPixels read_labels(const std::string& path);

/// The number of images in a TIFF file; 1 for all other files, unreadable ones included.
[[nodiscard]] int page_count(const std::string& path);

/// As read_grey, for one image of a TIFF file, counted from 0.
[[nodiscard]] ByteImage read_grey_page(const std::string& path, int page);

/// A file, which appears as a whole or not at all, or "-". Throws FileError.
void write_bytes(const std::string& path, std::string_view bytes);

/// Writes an 8-bit grey image in the format that the extension names; only formats that keep
/// every pixel are known. The file appears, or is replaced, as a whole or not at all. Throws
/// FileError.
void write_grey(const std::string& path, const ConstImageView& image);

/// The same for an image of 0 and 255 alone; .pbm is known, too.
void write_binary(const std::string& path, const ConstImageView& image);

/// The bytes of a PNG file. Throws FileError.
[[nodiscard]] std::string png_of(const ConstImageView& image);

/// As write_grey, with several images in one TIFF file.
void write_grey_pages(const std::string& path, const std::vector<ByteImage>& pages);

/// As write_grey, with 16 bits per pixel, in PNG, PGM or TIFF.
void write_deep(const std::string& path, const View<const std::uint16_t>& image);

/// Throws ExtensionError where the extension names no format that write_deep knows.
void check_deep_extension(const std::string& path);

/// Whether a PNG file has pixels that are not opaque. Throws FileError.
[[nodiscard]] bool is_transparent(const std::string& path);

/// Whether write_grey takes images of this size, which has pixels: below 2^31 of them.
[[nodiscard]] constexpr bool is_writable_size(Index width, Index height) {
  return width <= (kMaxImagePixels - 1) / height;
}

/// The name of an image to write has an extension that stands for no format.
struct ExtensionError : FileError {
  using FileError::FileError;
};

/// Throws ExtensionError where the extension names no format that write_grey knows.
void check_extension(const std::string& path);

/// The same for images with colours, and SVG.
void check_overlay_extension(const std::string& path);

/// While it lives, OpenCV uses no threads of its own: for programs whose threads share images.
class OneThreadPerImage {
 public:
  OneThreadPerImage();
  ~OneThreadPerImage();
  OneThreadPerImage(const OneThreadPerImage&) = delete;
  OneThreadPerImage& operator=(const OneThreadPerImage&) = delete;

 private:
  int threads_;  // before
};

}  // namespace thinbench
