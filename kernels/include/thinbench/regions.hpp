// Objects, holes and Euler numbers of binary images.
#pragma once

#include <cstdint>
#include <vector>

#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"
#include "thinbench/region.hpp"

namespace thinbench {

/// See Region for what the lists hold and how they are numbered.
struct Regions {
  std::vector<Region> objects;
  std::vector<Region> holes;
};

// In all of these 0 is background, anything else foreground; everything outside the image is
// background, objects are 8-connected and holes 4-connected. Of `options`, only technique, ISA and
// threads may be set. They may be called from any number of threads, and throw
// std::invalid_argument for a negative size, a stride below the width, a null image, sides above
// 2^29 or more than 2^32 pixels, and options that no variant fits; std::bad_alloc where memory is
// short.
//
// The paper's own relabelling scan is not offered: its count is correct on one object with thick
// walls only, and it has 254 labels. It is kept as holes_literal in reference/holes.hpp, to measure
// where it is correct.

/// All objects and all holes.
[[nodiscard]] Regions find_regions(ConstImageView source, const Options& options = {});

/// All objects alone, for less work.
[[nodiscard]] std::vector<Region> find_components(ConstImageView source,
                                                  const Options& options = {});

/// Objects minus holes; euler_number_4 has 4-connected objects and 8-connected holes.
[[nodiscard]] std::int64_t euler_number(ConstImageView source, const Options& options = {});
[[nodiscard]] std::int64_t euler_number_4(ConstImageView source, const Options& options = {});

/// Objects with all that they enclose, 255 on 0. The two are the same image or do not overlap.
void fill_holes(ConstImageView source, ImageView destination, const Options& options = {});

}  // namespace thinbench
