// What `thinbench verify` compares variants on.
#pragma once

#include <string>
#include <vector>

#include "harness/test_images.hpp"

namespace thinbench {

/// The built-in sets (without the big ones where `quick`), the scenes, and the pictures of these
/// files; as binary images with objects at or above 128, and as grey ones. Throws PictureError.
[[nodiscard]] std::vector<TestImageSet> verify_image_sets(bool quick,
                                                          const std::vector<std::string>& files);

}  // namespace thinbench
