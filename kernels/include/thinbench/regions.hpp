// Objects, holes and Euler numbers of binary images.
#pragma once

#include <cstdint>
#include <vector>

#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"
#include "thinbench/region.hpp"

namespace thinbench {

/// Numbered as Region describes.
struct Regions {
  std::vector<Region> objects;
  std::vector<Region> holes;
};

// In all functions 0 is background, anything else foreground; everything outside the image is
// background, objects are 8-connected and holes 4-connected. Of `options`, only technique, ISA and
// threads may be set. Any number of threads may call them at once. They throw std::invalid_argument
// for a negative size, a stride below the width, a null image, sides above 2^29 or more than 2^32
// pixels, and options that no variant fits; std::bad_alloc where memory is short.
//
// Source: section 2.2 of the paper, for the task but not the method. The paper's relabelling scan
// counts correctly on a single object with thick walls only and has 254 labels. It is in
// reference/holes.hpp, as holes_literal, to measure where it is correct.

/// All objects and all holes.
[[nodiscard]] Regions find_regions(ConstImageView source, const Options& options = {});

/// All objects without holes, which is faster.
[[nodiscard]] std::vector<Region> find_components(ConstImageView source,
                                                  const Options& options = {});

/// Objects minus holes; euler_number_4 has 4-connected objects and 8-connected holes.
[[nodiscard]] std::int64_t euler_number(ConstImageView source, const Options& options = {});
[[nodiscard]] std::int64_t euler_number_4(ConstImageView source, const Options& options = {});

/// Writes objects with all that they enclose: 255, else 0. The two views have one size; they are
/// the same image or share no pixel. Throws std::invalid_argument otherwise; nothing is written
/// then.
void fill_holes(ConstImageView source, ImageView destination, const Options& options = {});

}  // namespace thinbench
