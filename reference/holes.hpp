// Section 2.2 of the paper in plain code: the published hole detection, and objects and holes of
// any image.
#pragma once

#include <vector>

#include "thinbench/image_view.hpp"
#include "thinbench/region.hpp"

namespace thinbench::reference {

/// The result of the relabelling scan. `flag` is the smallest grey level assigned, 255 if there is
/// no point.
struct LiteralHoles {
  int flag = 255;

  /// The number of contours, and the paper's number of holes: all contours except the exterior one.
  [[nodiscard]] int contours() const { return 255 - flag; }
  [[nodiscard]] int holes() const { return flag == 255 ? 0 : 254 - flag; }
};

/// The relabelling scan, steps a) to e) as published, on an image of contours (255; anything else
/// is background and read as 0). Writes the grey levels to `labels`, of the same size.
///
///   a) Scan line by line to the first 255 point; it and the flag become 254.
///   b) Scan on to the next 255 point p, with the neighbours W, NW, N, NE as a, b, c, d.
///   c) If max(a, b, c, d) is 0 the flag is decremented and p becomes the flag; else p becomes the
///      maximum.
///   d) For each x of a, b, c, d below the maximum: from the point of step a) on, every x becomes
///      the maximum, all levels below x are incremented, and so is the flag.
///   e) Back to b) until no point is 255.
///
/// Everything outside the image is background. In d) background, 0, is neither an x nor
/// incremented, as the paper implies: its levels are those of contours. Throws std::length_error if
/// more than 254 levels are needed at once.
LiteralHoles holes_literal(ConstImageView contours, ImageView labels);

/// Writes 255 on object pixels with a background pixel to the west, north, east or south, else 0:
/// the input of holes_literal for a binary image.
void contours_of(ConstImageView source, ImageView destination);

/// Objects and holes as region.hpp defines them, each by flood fill from its first pixel.
struct Regions {
  std::vector<Region> objects;
  std::vector<Region> holes;
};
[[nodiscard]] Regions holes(ConstImageView source);

/// The objects only.
[[nodiscard]] Regions objects(ConstImageView source);

/// The same, and the label of every pixel: the number of its object from 1; the number of objects
/// plus that of its hole; else 0.
Regions label_regions(ConstImageView source, LabelView labels);

/// Objects that are 8- or 4-connected, numbered in raster order of first pixels, and the number of
/// each pixel's object, 0 in the background.
std::vector<Region> label_objects(ConstImageView source, LabelView labels);
std::vector<Region> label_objects_4(ConstImageView source, LabelView labels);

/// Writes 255 on objects and everything they enclose: only background that is 4-connected to the
/// border remains background. `destination` may be the source.
void fill_holes(ConstImageView source, ImageView destination);

/// The same for 4-connected objects: only background that is 8-connected to the border remains.
void fill_holes_4(ConstImageView source, ImageView destination);

/// Fills only holes of at most `max_area` pixels; those of 4-connected objects are 8-connected.
void fill_small_holes(ConstImageView source, ImageView destination, bool four_connected,
                      std::int64_t max_area);

/// Fills the holes of each label alone: a pixel of the background gets the label of the one that
/// begins last in raster order among the holes that contain it, if this one has at most `max_area`
/// such pixels. Labels are 8- or 4-connected.
void fill_label_holes(ConstLabelView source, LabelView destination, bool four_connected,
                      std::int64_t max_area);

/// Objects minus holes, by counting both: 8-connected objects and 4-connected holes, or 4-connected
/// objects and 8-connected holes.
[[nodiscard]] std::int64_t euler_number(ConstImageView source);
[[nodiscard]] std::int64_t euler_number_4(ConstImageView source);

}  // namespace thinbench::reference
