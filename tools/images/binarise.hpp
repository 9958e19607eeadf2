// Which pixels of a grey image are foreground: the one rule that all programs follow.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "support/byte_image.hpp"
#include "thinbench/packed.hpp"

namespace thinbench {

enum class Foreground : std::uint8_t { automatic, bright, dark };

/// As options name them, in the order of the enumerators.
inline constexpr std::array<std::string_view, 3> kForegroundNames = {"auto", "bright", "dark"};

[[nodiscard]] constexpr std::string_view foreground_name(Foreground foreground) {
  return kForegroundNames[static_cast<std::size_t>(foreground)];
}

struct BinariseOptions {
  /// automatic: the class that covers less of the image border, as the background surrounds what
  /// is shown; where both cover as much, the smaller class, and of equal ones the bright.
  Foreground foreground = Foreground::automatic;
  /// Pixels are bright at this grey level and above, [0, 255]; where there is none, above the level
  /// that OpenCV finds by Otsu's method.
  std::optional<int> threshold = std::nullopt;
  /// Corrupt and truncated JPEG files are read as far as possible, with a warning.
  bool lenient = false;
};

/// A binary image, and what it was made from.
struct BinaryImage {
  ByteImage image;                // 255 on foreground, 0 elsewhere
  Foreground foreground;          // bright or dark
  int threshold;                  // pixels are bright at this grey level and above
  double foreground_share;        // of all pixels
  double separation;              // the share of the variance that lies between the two classes
  std::optional<int> only_level;  // where all pixels have this one
  bool was_binary;                // all grey levels were 0 or 255
};

/// Below this separation the histogram counts as one without two classes. Otsu's threshold puts
/// 3/4 of the variance between the halves of a uniform histogram, in which no level is a better
/// limit than any other, and 2/pi of it between those of a normal one; so all that is not clearly
/// above 3/4 shows one class, cut in two. Images of two classes are far above: 0.97 and more for
/// drawings, silhouettes and backlit parts. Uneven light takes a photograph below the limit, and
/// there one threshold for the whole image is indeed a doubtful choice.
inline constexpr double kMinSeparation = 0.8;

/// The image, which has pixels, in two classes.
[[nodiscard]] BinaryImage binarise(ByteImage grey, const BinariseOptions& options = {});

/// The bright pixels of an image of two classes.
struct BrightPixels {
  Index bright = 0;
  Index all = 0;
  Index bright_on_border = 0;  // of the outermost rows and columns
  Index all_on_border = 0;
};

/// Adds rows of a packed image of this height, the first of which is its row `y`. 1 is bright,
/// unused bits are 0, the first pixel is the most significant bit of a byte.
void add_rows(BrightPixels& count, const ConstPackedView& rows, Index y, Index height);

/// What binarise() says of an image of 0 and 255 with these bright pixels. Its `image` is empty.
[[nodiscard]] BinaryImage binarise_packed(const BrightPixels& count,
                                          const BinariseOptions& options);

/// What is doubtful about it, a line each: one grey level only, a threshold found in a histogram
/// without two classes, more than half of the image as foreground.
[[nodiscard]] std::vector<std::string> warnings(const BinaryImage& binary,
                                                const BinariseOptions& options);

/// Writes to `log` what there is to say of the binary image made from the image `name`, one line
/// each: "note: ..." with what was chosen, unless the image was binary and bright is foreground;
/// "warning: ..." with each of its warnings.
void print_remarks(const std::string& name, const BinaryImage& binary,
                   const BinariseOptions& options, std::ostream& log);

/// As read_grey, and leniently where the options say so; a warning of the decoder goes to `log`.
[[nodiscard]] ByteImage read_grey(const std::string& path, const BinariseOptions& options,
                                  std::ostream& log);

/// Reads the image at `path` and binarises it, with the remarks in `log`, if there is one. Throws
/// FileError.
[[nodiscard]] ByteImage read_binary(const std::string& path, const BinariseOptions& options = {},
                                    std::ostream* log = nullptr);

/// How many pixels are not 0.
[[nodiscard]] Index foreground_pixels(ConstImageView image);

}  // namespace thinbench
