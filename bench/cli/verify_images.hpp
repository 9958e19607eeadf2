// What `thinbench verify` compares variants on.
#pragma once

#include <string>
#include <vector>

#include "harness/test_images.hpp"
#include "picture/binarise.hpp"

namespace thinbench {

/// The built-in sets (without the big ones where `quick`), the scenes, and the images in these
/// files, binarised, with the remarks in `log`, and as they are. Throws PictureError.
[[nodiscard]] std::vector<TestImageSet> verify_image_sets(bool quick,
                                                          const std::vector<std::string>& files,
                                                          const BinariseOptions& binarise,
                                                          std::ostream& log);

}  // namespace thinbench
