// A path drawn over the map in which it was found.
#pragma once

#include <string>
#include <vector>

#include "thinbench/graph.hpp"
#include "thinbench/image_view.hpp"

namespace thinbench {

/// Writes `grey` with the path in orange, a light band as wide as the robot around it, and circles
/// at start (green) and goal (red). The file appears as a whole or not at all. Throws FileError.
void write_path_overlay(const std::string& path, const ConstImageView& grey,
                        const std::vector<Pixel>& pixels, double width);

}  // namespace thinbench
