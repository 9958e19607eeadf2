// What can be counted and measured on a skeleton. Outside the image everything is background.
#pragma once

#include "support/byte_image.hpp"

namespace thinbench {

struct Topology {
  Index objects = 0;  // 8-connected, foreground
  Index holes = 0;    // 4-connected, background, not connected with the outside
};

[[nodiscard]] Topology topology_of(const ConstImageView& image);

struct SkeletonShape {
  Index pixels = 0;
  Index blocks = 0;    // windows of 2 x 2 foreground pixels
  Index ends = 0;      // foreground pixels with one foreground neighbour of the eight
  Index branches = 0;  // with three or more steps from background to foreground on the way round
};

[[nodiscard]] SkeletonShape shape_of(const ConstImageView& skeleton);

/// 255 on the medial axis: the ridge of d, the exact Euclidean distance to the nearest
/// background pixel. A foreground pixel p is on it where d rises nowhere steeply: d(q) - d(p) < 0.8
/// |p - q| for all q up to three rows and columns away. Away from the axis d rises by |p - q|
/// towards it; 0.8 leaves room for the pixel grid and leaves the axes of corners up to 106 degrees
/// in.
[[nodiscard]] ByteImage medial_axis_of(const ConstImageView& image);

struct AxisDistance {
  double mean = 0;
  double largest = 0;
};

/// From the foreground pixels of a skeleton to the nearest pixel of the axis; 0 where there are
/// none.
[[nodiscard]] AxisDistance distance_from(const ConstImageView& axis,
                                         const ConstImageView& skeleton);

/// Foreground pixels of both, as a share of those of either; 1 where there are none.
[[nodiscard]] double overlap(const ConstImageView& a, const ConstImageView& b);

/// Rotated by a quarter turn, anticlockwise.
[[nodiscard]] ByteImage rotated_by_quarter(const ConstImageView& image);

}  // namespace thinbench
