// Which pixels of a grey image are foreground: the one rule that all programs follow.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "binarise/bright_pixels.hpp"
#include "images/grey_image.hpp"
#include "support/file_bytes.hpp"
#include "thinbench/binarise.hpp"
#include "thinbench/packed.hpp"

namespace thinbench {

/// How an image file becomes an image of two classes.
struct BinariseOptions {
  Foreground foreground = Foreground::automatic;   // as in Binarisation, as are the next two
  std::optional<double> threshold = std::nullopt;  // in the file's numbers
  /// Damaged JPEG and TIFF files are read as far as possible, with a warning.
  bool lenient = false;
  std::optional<LocalThreshold> local = std::nullopt;
  std::optional<double> offset = std::nullopt;  // of the local threshold, in the file's numbers
  GreyChoice grey = {};
  /// More foreground than background is nothing doubtful, as free space in maps.
  bool is_mostly_foreground = false;
};

/// A binary image, and what it was made from.
struct BinaryImage : Binarised {
  ByteImage image;                             // 255 on foreground, 0 elsewhere
  double first = 0, step = 1;                  // what levels stand for, see GreyImage
  std::optional<double> given = std::nullopt;  // the threshold that was
  std::string range = {};                      // "16 bits, levels 480 to 733"; empty for 8 bits

  [[nodiscard]] double number_of(int level) const { return first + step * level; }
  /// The threshold, in the file's numbers.
  [[nodiscard]] double number() const { return given.value_or(number_of(threshold)); }
};

/// A threshold for the whole image is doubtful where the classes overlap: where so large a share of
/// the pixels lies near it, and less of the variance between the classes. One of the two alone says
/// little: a few bright stars, or a drawing of three levels, have a low separation, and drawings of
/// neighbouring levels many pixels near the threshold. Of uniform noise 10 % is near, and 75 % of
/// the variance lies between the classes.
inline constexpr double kMaxUndecided = 0.05;
inline constexpr double kMinSeparation = 0.8;

/// The image, which has pixels, in two classes. Throws std::invalid_argument for a threshold above
/// the levels of 8 or 16 bits; numbers have no highest one.
[[nodiscard]] BinaryImage binarise(GreyImage grey, const BinariseOptions& options = {});
[[nodiscard]] BinaryImage binarise(ByteImage grey, const BinariseOptions& options = {});

using detail::BrightPixels;

/// The number of foreground pixels of a packed image whose unused bits are 0.
[[nodiscard]] Index packed_foreground(const ConstPackedView& image);

/// Adds rows of a packed image of this height, the first of which is its row `y`. 1 is bright,
/// unused bits are 0, the first pixel is the most significant bit of a byte.
void add_rows(BrightPixels& count, const ConstPackedView& rows, Index y, Index height);

/// What binarise() says of an image of 0 and 255 with these bright pixels. Its `image` is empty.
[[nodiscard]] BinaryImage binarise_packed(const BrightPixels& count,
                                          const BinariseOptions& options);

/// "bright (grey level >= 108)": what is foreground.
[[nodiscard]] std::string class_text(const BinaryImage& binary);

/// What is doubtful about it, a line each: one grey level only, a threshold that many pixels are
/// near, more than half of the image as foreground.
[[nodiscard]] std::vector<std::string> warnings(const BinaryImage& binary,
                                                const BinariseOptions& options);

/// Writes to `log` what there is to say of the binary image made from the image `name`, one line
/// each: "note: ..." with what was chosen, unless the image was binary and bright is foreground;
/// "warning: ..." with each of its warnings.
void print_remarks(const std::string& name, const BinaryImage& binary,
                   const BinariseOptions& options, std::ostream& log);

/// Grey levels of an image file, and how they came about.
struct GreyFile {
  GreyImage grey;
  Channel channel;      // that was chosen
  std::string warning;  // of the decoder, or that the image is transparent
};

/// The page of an image file, counted from 0, by what the options name. The bytes are freed as soon
/// as there are pixels. Throws FileError.
[[nodiscard]] GreyFile read_grey_file(FileBytes file, int page, const BinariseOptions& options);

/// The same for the first image of a file, or of standard input; the warning and an automatic
/// choice go to `log`, a line each.
[[nodiscard]] GreyImage read_levels(FileBytes file, const BinariseOptions& options,
                                    std::ostream& log);

/// The same in 8 bits.
[[nodiscard]] ByteImage read_grey(const std::string& path, const BinariseOptions& options,
                                  std::ostream& log);

/// Reads the image at `path` and binarises it, with the remarks in `log`, if there is one. Throws
/// FileError.
[[nodiscard]] ByteImage read_binary(FileBytes file, const BinariseOptions& options,
                                    std::ostream& log);
[[nodiscard]] ByteImage read_binary(const std::string& path, const BinariseOptions& options = {},
                                    std::ostream* log = nullptr);

/// How many pixels are not 0.
[[nodiscard]] Index foreground_pixels(ConstImageView image);

}  // namespace thinbench
