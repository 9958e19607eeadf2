// Objects, holes and Euler numbers of binary images.
#pragma once

#include <cstdint>
#include <vector>

#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"
#include "thinbench/region.hpp"

namespace thinbench {

/// In the order of ids; see Region.
struct Regions {
  std::vector<Region> objects;
  std::vector<Region> holes;
};

// In all functions 0 is background and anything else is foreground; everything outside the image is
// background; objects are 8-connected and holes 4-connected. Of `options`, only technique, ISA and
// threads may be set. All functions are thread-safe. They throw std::invalid_argument for a
// negative size, a stride below the width, a null image, a side above 2^29 or more than 2^32
// pixels, and options that no variant fits, and std::bad_alloc if memory runs out.
//
// Source: section 2.2 of the paper, for the task but not the method. The paper's relabelling scan
// has 254 labels and is correct only for a single object with thick walls. reference/holes.hpp has
// it, as holes_literal, to measure where it is correct.

/// All objects and all holes.
[[nodiscard]] Regions find_regions(ConstImageView source, const Options& options = {});

/// All objects. Faster than find_regions, as it skips holes.
[[nodiscard]] std::vector<Region> find_components(ConstImageView source,
                                                  const Options& options = {});

/// Number of objects minus number of holes. euler_number_4 uses 4-connected objects and 8-connected
/// holes.
[[nodiscard]] std::int64_t euler_number(ConstImageView source, const Options& options = {});
[[nodiscard]] std::int64_t euler_number_4(ConstImageView source, const Options& options = {});

/// Fills holes: writes 255 for objects and everything they enclose, else 0. Thread-safe for
/// different destinations. Both views must have the same size and be the same image or share no
/// pixel; throws std::invalid_argument otherwise. Nothing is written if it throws.
void fill_holes(ConstImageView source, ImageView destination, const Options& options = {});

}  // namespace thinbench
