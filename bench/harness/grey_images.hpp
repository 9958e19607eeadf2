// Grey inputs on which variants are compared with references.
#pragma once

#include "harness/test_images.hpp"

namespace thinbench {

/// Grey levels `lowest` to `highest`, all equally likely. The same bytes on every machine.
[[nodiscard]] ByteImage grey_noise_image(Index width, Index height, std::uint8_t lowest,
                                         std::uint8_t highest, std::uint64_t seed);

/// Noise of all levels and of few at widths 1 to 200 and around 512 and 1024 by two heights each;
/// constant images, ramps, steps and checkerboards of extremes, down to images without pixels.
[[nodiscard]] std::vector<TestImageSet> grey_image_sets();

}  // namespace thinbench
