// What decoders do not tell: that a file is a picture, but one without pixels.
#pragma once

#include <string>

namespace thinbench {

/// Whether the file begins like a PNG, BMP or PNM picture whose width or height is 0.
[[nodiscard]] bool declares_no_pixels(const std::string& path);

}  // namespace thinbench
