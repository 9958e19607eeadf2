// What can be counted and measured on a skeleton. Outside the image everything is light.
#pragma once

#include "support/byte_image.hpp"

namespace thinbench {

struct Topology {
  Index objects = 0;  // 8-connected, dark
  Index holes = 0;    // 4-connected, light, not connected with the outside
};

[[nodiscard]] Topology topology_of(const ConstImageView& image);

struct SkeletonShape {
  Index pixels = 0;
  Index blocks = 0;    // windows of 2 x 2 dark pixels
  Index ends = 0;      // dark pixels with one dark neighbour of the eight
  Index branches = 0;  // dark pixels with three or more steps from light to dark on the way round
};

[[nodiscard]] SkeletonShape shape_of(const ConstImageView& skeleton);

/// 255 on the medial axis: the ridge of d, the exact Euclidean distance to the nearest light pixel.
/// A dark pixel p is on it where d rises nowhere steeply: d(q) - d(p) < 0.8 |p - q| for all q up to
/// three rows and columns away. Away from the axis d rises by |p - q| towards it; 0.8 leaves room
/// for the pixel grid and leaves the axes of corners up to 106 degrees in.
[[nodiscard]] ByteImage medial_axis_of(const ConstImageView& image);

struct AxisDistance {
  double mean = 0;
  double largest = 0;
};

/// From the dark pixels of a skeleton to the nearest pixel of the axis; 0 where there are none.
[[nodiscard]] AxisDistance distance_from(const ConstImageView& axis, const ConstImageView& skeleton);

/// Pixels dark in both, as a share of those dark in either; 1 where none is.
[[nodiscard]] double overlap(const ConstImageView& a, const ConstImageView& b);

/// Turned by a quarter, anticlockwise.
[[nodiscard]] ByteImage quarter_turned(const ConstImageView& image);

}  // namespace thinbench
