// The known geometry of a scene as JSON text.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace thinbench {

/// An object with width, height, threshold, convention (the coordinates, in words), parts and
/// holes, indented by two. Area and centre of a part that the image border cuts off are null, and
/// its box ends at the image border.
[[nodiscard]] std::string scene_truth_json(const Scene& scene);

}  // namespace thinbench
