// The images that are measured: image files and drawn images with names that say how to make
// them again.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "harness/operation.hpp"
#include "images/binarise.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {

struct TimedInput {
  std::string name;
  ByteImage binary;  // 0 and 255
  ByteImage grey;    // the image that the binary one was made from

  [[nodiscard]] Index width() const { return binary.width(); }
  [[nodiscard]] Index height() const { return binary.height(); }
  /// What an operation is measured on. For one thread at a time.
  [[nodiscard]] ConstImageView view(const Operation& operation) const {
    if (operation.takes == InputKind::grey) return grey.view();
    if (!operation.measured_on_skeletons) return binary.view();
    if (skeleton.width() == 0) {
      skeleton = ByteImage(width(), height());
      thin(Rule::guo_hall, binary.view(), skeleton.view());
    }
    return skeleton.view();
  }

  mutable ByteImage skeleton = {};  // of the binary image, once it is needed
};

struct InputChoice {
  std::vector<std::string> pictures;  // image files
  BinariseOptions binarise = {};      // of the image files
  std::vector<std::string> drawn;     // names, see drawn_input()
};

/// The image of a name:
///   scene             the built-in scene, 510 x 412
///   square_N          N x N pixels of the scene, repeated as tiles
///   tiled_N           the scene repeated N x N times
///   enlarged_N        the scene, each pixel replaced by N x N pixels
///   noise_N_P_G       N x N pixels of random G x G blocks, P percent of them foreground
///   squares_N_S       N x N pixels, foreground squares of side S at distance S
///   halftone_N        N x N pixels of dots that grow until what they leave are holes
///   page_N            N x N pixels of lines of drawn characters
///   strokes_N_C       C images of N x N pixels, each a thick line, one below the other
/// Throws UsageError for any other name.
[[nodiscard]] TimedInput drawn_input(const std::string& name);

/// The image files, then the drawn images; the scene where both lists are empty. Names are unique
/// and hold no '/'; no image file gets a name that drawn_input() knows. Remarks on the image files
/// go to `log` if there is one. Throws FileError, and UsageError for unknown names.
[[nodiscard]] std::vector<TimedInput> timed_inputs(const InputChoice& choice,
                                                   std::ostream* log = nullptr);

/// Every 5th pixel of every 16th row, named "<input>_small": the scene becomes 102 x 26 pixels,
/// more than a word in a row and few rows, with all its parts and most of their holes.
[[nodiscard]] TimedInput small_copy(const TimedInput& input);

/// FNV-1a over the pixels, row by row.
[[nodiscard]] std::uint64_t pixel_hash(ConstImageView image);

}  // namespace thinbench
