// Paths for robots on the skeleton of the free space, far from obstacles.
#pragma once

#include <optional>
#include <vector>

#include "thinbench/export.h"
#include "thinbench/graph.hpp"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench {

struct PathRequest {
  Pixel start;
  Pixel goal;
  double width = 0;  // of the robot, a disc, in pixels
};

struct FoundPath {
  std::vector<Pixel> pixels;  // from start to goal, each one of the eight neighbours of the last
  double length;              // steps along rows and columns count 1, diagonal ones sqrt(2)
  double min_width;  // twice the smallest distance from steps to obstacles; infinite without one
};

/// Cost per unit of length off the skeleton; on the skeleton it is 1.
inline constexpr double kPathOffSkeletonCost = 4;

/// The path of lowest cost from start to goal, in a map whose foreground is free. A step between
/// two pixels of the skeleton costs its length, any other step kPathOffSkeletonCost times its
/// length; so from a pixel of the skeleton to another no path along the skeleton is shorter. The
/// skeleton is that of Rule::guo_hall without branches shorter than the free space is wide at their
/// junction. All points of the path, which are on straight lines between centres of pixels, are at
/// least width / 2 from centres of obstacles, and no step leads between two obstacles that touch at
/// a corner. What is outside the image is no obstacle. There is a path wherever such steps lead
/// from start to goal; else nothing is returned.
///
/// Takes 24 bytes of memory per pixel. Thread-safe. Throws std::invalid_argument for a start or
/// goal that is outside, on an obstacle or too near to one, for a width that is negative or no
/// number, and as skeleton_graph and squared_distances; and std::bad_alloc.
[[nodiscard]] THINBENCH_API std::optional<FoundPath> find_path(ConstImageView free,
                                                               const PathRequest& request,
                                                               const Execution& execution = {});

}  // namespace thinbench
