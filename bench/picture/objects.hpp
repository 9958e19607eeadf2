// Which pixels of a grey picture are objects.
#pragma once

#include "support/byte_image.hpp"

namespace thinbench {

inline constexpr int kDefaultThreshold = 128;

/// 255 where the grey level is at or above the threshold (`invert`: below it), 0 elsewhere.
[[nodiscard]] ByteImage objects_of(ByteImage grey, int threshold = kDefaultThreshold,
                                   bool invert = false);

/// How many pixels are not 0.
[[nodiscard]] Index object_pixels(ConstImageView image);

}  // namespace thinbench
