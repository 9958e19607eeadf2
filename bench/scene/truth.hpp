// Parts and holes of a scene with their true geometry and their ids.
#pragma once

#include <vector>

#include "support/byte_image.hpp"
#include "scene/layout.hpp"
#include "scene/scene.hpp"

namespace thinbench::scene_detail {

/// The layout at its final place and size: outlines clockwise around parts, anticlockwise around
/// holes, nudges and scale applied.
[[nodiscard]] std::vector<PartShape> scaled_layout(const SceneOptions& options);

struct Truth {
  std::vector<ScenePart> parts;
  std::vector<SceneHole> holes;
};

/// Measures a scaled layout; the binary image only serves to number parts and holes.
[[nodiscard]] Truth measure(const std::vector<PartShape>& layout, ConstImageView binary);

}  // namespace thinbench::scene_detail
