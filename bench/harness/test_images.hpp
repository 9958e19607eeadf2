// Inputs on which variants are compared with references: small and awkward.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "harness/job.hpp"

namespace thinbench {

/// A named input. `name` says how to make it again (size, density, granularity, seed).
struct TestImage {
  std::string name;
  ByteImage image;
  InputKind kind = InputKind::binary;
};

/// Random blocks of `granularity` x `granularity` pixels, each foreground with probability
/// `percent` / 100. The same bytes on every machine.
[[nodiscard]] ByteImage noise_image(Index width, Index height, int percent, Index granularity,
                                    std::uint64_t seed);

/// The image of a number: pixel (x, y) is foreground where bit y * width + x is set.
[[nodiscard]] ByteImage image_of_bits(Index width, Index height, std::uint64_t bits);

/// All 512 neighbourhoods in cells of 4 x 4 pixels, the first cell at column `phase`.
[[nodiscard]] ByteImage neighbourhood_sheet(Index phase);

/// `count` images of `side` x `side` pixels one below the other, as scanned digits: each a line
/// through 3 to 6 random points, 2 to 4 28ths of the side thick, whose points are 4 28ths of it or
/// more from the border of their image. Sides up to 1024. The same bytes on every machine.
[[nodiscard]] ByteImage stroke_images(Index count, Index side, std::uint64_t seed);

using TestImageSink = std::function<void(const TestImage&)>;

/// A family of inputs that can be generated one after another.
struct TestImageSet {
  std::string name;
  std::string claim;  // what the set covers
  std::function<void(const TestImageSink&)> generate;
  InputKind kind = InputKind::binary;
};

/// Binary: widths 1 to 200 and around 512 and 1024 by five heights; all 4 x 4 images; every
/// neighbourhood at every phase of a word; plain, empty and border-touching shapes; combs, spirals
/// and lattices; images of many tiles. Grey: see grey_image_sets.
[[nodiscard]] const std::vector<TestImageSet>& test_image_sets();

/// Grey levels `lowest` to `highest`, all equally likely. The same bytes on every machine.
[[nodiscard]] ByteImage grey_noise_image(Index width, Index height, std::uint8_t lowest,
                                         std::uint8_t highest, std::uint64_t seed);

/// Noise of all levels and of few at widths 1 to 200 and around 512 and 1024 by two heights each;
/// constant images, ramps, steps and checkerboards of extremes, down to images without pixels.
[[nodiscard]] std::vector<TestImageSet> grey_image_sets();

}  // namespace thinbench
