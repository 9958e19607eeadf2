// Smoothing of grey levels.
#pragma once

#include "images/pixels.hpp"

namespace thinbench {

/// A Gaussian filter of this standard deviation, in place; pixels of one channel, of 8 or 16 bits.
/// Pixels beyond the border are those on it. Of 8 bits the same as OpenCV's.
void blur(const Pixels& image, double sigma);

}  // namespace thinbench
