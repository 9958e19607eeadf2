// The images that are timed.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "harness/job.hpp"
#include "picture/binarise.hpp"

namespace thinbench {

struct TimedInput {
  std::string name;
  ByteImage binary;  // 0 and 255
  ByteImage grey;    // the picture that the binary image was made from
  bool size_sweep;   // one of a series of sizes, timed on fewer rows

  [[nodiscard]] Index width() const { return binary.width(); }
  [[nodiscard]] Index height() const { return binary.height(); }
  [[nodiscard]] ConstImageView view(InputKind kind) const {
    return kind == InputKind::grey ? grey.view() : binary.view();
  }
};

struct InputChoice {
  std::vector<std::string> pictures;  // files to use instead of the scene
  Index largest_square = 4096;        // where the series of sizes ends; 0 for no series
  BinariseOptions binarise = {};      // of the pictures
  std::ostream* log = nullptr;        // gets the remarks on them
};

/// The scene, or the pictures, binarised, and then squares of 64 x 64 and doubled sizes cut from
/// the scene laid out like tiles. Names are unique and hold no '/'; a picture never gets the name
/// of the scene or of a square, which reports treat apart. Throws PictureError.
[[nodiscard]] std::vector<TimedInput> timed_inputs(const InputChoice& choice);

/// The image laid out again and again, from its top left corner on.
[[nodiscard]] ByteImage tiled(const ByteImage& tile, Index width, Index height);

/// FNV-1a over the pixels, row by row, as 16 hexadecimal digits: names what was timed.
[[nodiscard]] std::string pixel_hash(ConstImageView image);

}  // namespace thinbench
