// Objects, holes and Euler numbers of binary images.
#pragma once

#include <cstdint>
#include <vector>

#include "thinbench/export.h"
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
// background; objects are 8-connected and holes 4-connected. All functions are thread-safe; all but
// label_values and fill_holes share a large image among threads. They
// throw std::invalid_argument for a negative size, a stride below the width, a null image, a side
// above 2^29 or more than 2^32 pixels, threads out of range and an ISA that is not available, and
// std::bad_alloc if memory runs out.
//
// Source: section 2.2 of the paper, for the task but not the method. The paper's relabelling scan
// has 254 labels and is correct only for a single object with thick walls. reference/holes.hpp has
// it, as holes_literal, to measure where it is correct.

/// All objects and all holes.
[[nodiscard]] THINBENCH_API Regions find_regions(ConstImageView source,
                                                 const Execution& execution = {});

/// All objects. Faster than find_regions, as it skips holes.
[[nodiscard]] THINBENCH_API std::vector<Region> find_objects(ConstImageView source,
                                                             const Execution& execution = {});

/// Finds objects and holes and writes the label of each pixel's region: the id of its object, or
/// the number of objects plus the id of its hole, or 0 outside. Besides the result, takes up to 16
/// bytes of memory per run of equal pixels in a row, 52 per region and a quarter per pixel. Both
/// views must have the same size, at most 2^31 pixels, and share no byte. If it throws, nothing is
/// written, except that the labels may be where it is std::bad_alloc.
THINBENCH_API Regions label_regions(ConstImageView source, LabelView labels,
                                    const Execution& execution = {});

enum class Connectivity : std::uint8_t { four = 4, eight = 8 };

/// How objects are numbered: in raster order of their first pixels, or as OpenCV's
/// connectedComponents does by default, which is the same for 4-connected objects; 8-connected ones
/// are in raster order of their first blocks of 2 x 2 pixels, at even coordinates.
enum class LabelOrder : std::uint8_t { pixels, opencv };

/// The same for objects alone, which may be 4-connected; holes get label 0.
THINBENCH_API std::vector<Region> label_objects(ConstImageView source, LabelView labels,
                                                Connectivity connectivity = Connectivity::eight,
                                                LabelOrder order = LabelOrder::pixels,
                                                const Execution& execution = {});

/// The same labels without the list, in less time. Returns the number of objects.
THINBENCH_API std::uint32_t label_image(ConstImageView source, LabelView labels,
                                        Connectivity connectivity = Connectivity::eight,
                                        LabelOrder order = LabelOrder::pixels,
                                        const Execution& execution = {});

/// Labels components of equal values, in an image of any 32-bit values: 4- or 8-connected sets of
/// pixels with one value, such as the parts of each label. Labels count in raster order of first
/// pixels; pixels of the value `background` get 0. Returns the number of components. Both views
/// must have the same size, at most 2^31 pixels, and share no byte. Uses one thread and the
/// baseline's instructions.
THINBENCH_API std::uint32_t label_values(ConstLabelView values, LabelView labels,
                                         Connectivity connectivity = Connectivity::eight,
                                         std::int32_t background = 0,
                                         const Execution& execution = {});

/// Number of objects minus number of holes. Objects are 8- or 4-connected, holes the other way
/// round.
[[nodiscard]] THINBENCH_API std::int64_t euler_number(ConstImageView source,
                                                      Connectivity objects = Connectivity::eight,
                                                      const Execution& execution = {});

/// Holes of any area, see HoleFilling.
inline constexpr std::int64_t kAnyHoleArea = INT64_MAX;

/// Which holes are filled: those of 8- or 4-connected objects (or labels), which are connected the
/// other way round, with at most `max_area` pixels, not counting objects inside them.
struct HoleFilling {
  Connectivity objects = Connectivity::eight;
  std::int64_t max_area = kAnyHoleArea;
};

/// Fills holes: writes 255 for objects and the holes to be filled, else 0. Filling holes of any
/// area fills everything that objects enclose. Thread-safe for different destinations. Both views
/// must have the same size and be the same image or share no pixel; throws std::invalid_argument
/// otherwise, and for a negative area. Nothing is written if it throws.
THINBENCH_API void fill_holes(ConstImageView source, ImageView destination,
                              const HoleFilling& filling = {}, const Execution& execution = {});

/// Fills the holes of labels: a pixel of the background gets the label of the innermost hole around
/// it, all others keep theirs. The holes of a label are those of an image of this label alone. Of
/// several around a pixel, the innermost is the one whose first pixel is last in raster order. The
/// area of a hole is the number of pixels that change.
///
/// 0 is background, and so is everything outside the image; labels may be any other numbers, and a
/// label may have several components. Takes 10.2 bytes of memory per pixel, up to 13 per run of
/// equal labels in a row, background included, and 4 more per pixel where labels touch, at corners,
/// too; then the image is searched several times, usually two to five.
///
/// Both views must have the same size, at most 2^31 pixels, and be the same image or share no
/// pixel. Thread-safe for different destinations. Throws as fill_holes() does; nothing is written
/// if it throws.
THINBENCH_API void fill_holes_of_labels(ConstLabelView source, LabelView destination,
                                        const HoleFilling& filling = {},
                                        const Execution& execution = {});

}  // namespace thinbench
