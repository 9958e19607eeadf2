#include <algorithm>
#include <array>

#include "harness/splitmix64.hpp"
#include "harness/test_images.hpp"

namespace thinbench {
namespace {

struct Levels {
  std::uint8_t lowest;
  std::uint8_t highest;
};
/// All levels; levels around thresholds; levels whose differences are small.
constexpr std::array kLevels = {Levels{0, 255}, Levels{90, 170}, Levels{118, 138}, Levels{0, 40},
                                Levels{215, 255}};

std::string size_text(Index width, Index height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

TestImage noise(Index width, Index height, const Levels& levels, std::uint64_t seed) {
  std::string name = "grey noise " + size_text(width, height) + ", " +
                     std::to_string(levels.lowest) + " to " + std::to_string(levels.highest) +
                     ", seed " + std::to_string(seed);
  return {std::move(name), grey_noise_image(width, height, levels.lowest, levels.highest, seed),
          InputKind::grey};
}

void generate_noise(const TestImageSink& sink) {
  std::uint64_t seed = 1;
  const auto show = [&](Index width) {
    // One kind a size, in turn: all kinds meet all residues of the width.
    for (const Index height : {width % 5 + 1, Index{17}}) {
      sink(noise(width, height, kLevels[seed % 5], seed));
      ++seed;
    }
  };
  for (Index width = 1; width <= 200; ++width) show(width);
  for (const Index width : {509, 510, 511, 512, 513, 514, 1023, 1024, 1025}) show(width);
  // Narrower than vectors and so high that engines take more than one band of rows.
  for (const auto& [width, height] : {std::pair<Index, Index>{5, 100}, {31, 65}, {63, 130}}) {
    for (const Levels& levels : kLevels) sink(noise(width, height, levels, seed++));
  }
  sink(noise(65551, 5, kLevels[0], seed));  // wider than 16 bits
}

/// Images in which differences are as large as they get, exactly at a step, or always the same.
void show_shapes(Index width, Index height, const TestImageSink& sink) {
  const auto show = [&](const char* name, const auto& level) {
    sink({std::string(name).append(" ").append(size_text(width, height)),
          image_by(width, height, level), InputKind::grey});
  };
  show("black", [](Index, Index) { return 0; });
  show("grey 128", [](Index, Index) { return 128; });
  show("white", [](Index, Index) { return 255; });
  show("ramp to the right", [](Index x, Index) { return x * 3 % 256; });
  show("ramp downwards", [](Index, Index y) { return y * 17 % 256; });
  show("slope", [](Index x, Index y) { return (x * 5 + y * 7) % 256; });
  show("checkerboard", [](Index x, Index y) { return (x + y) % 2 * 255; });
  show("checkerboard of 2", [](Index x, Index y) { return (x / 2 + y / 2) % 2 * 255; });
  show("columns of 3", [](Index x, Index) { return x / 3 % 2 * 255; });
  show("rows of 3", [](Index, Index y) { return y / 3 % 2 * 255; });
  show("steps", [](Index x, Index y) { return 100 + x / 8 % 8 * 4 + y / 8 % 2 * 20; });
  show("dots", [](Index x, Index y) { return x % 7 == 3 && y % 5 == 2 ? 255 : 0; });
  show("holes", [](Index x, Index y) { return x % 7 == 3 && y % 5 == 2 ? 0 : 255; });
}

void generate_shapes(const TestImageSink& sink) {
  for (const auto& [width, height] :
       {std::pair<Index, Index>{0, 0}, {0, 7}, {7, 0}, {1, 1}, {64, 64}, {65, 33}, {510, 40}}) {
    show_shapes(width, height, sink);
  }
  for (Index width = 1; width <= 7; ++width) {
    for (Index height = 1; height <= 7; ++height) show_shapes(width, height, sink);
  }
}

}  // namespace

ByteImage grey_noise_image(Index width, Index height, std::uint8_t lowest, std::uint8_t highest,
                           std::uint64_t seed) {
  const std::uint64_t levels = static_cast<std::uint64_t>(highest - lowest) + 1;
  return image_by(width, height, [&](Index x, Index y) {
    const auto place = static_cast<std::uint64_t>(y << 32 | x);
    return lowest + splitmix64(splitmix64(seed) ^ place) % levels;
  });
}

std::vector<TestImageSet> grey_image_sets() {
  return {{"grey_shapes", "constant images, ramps, steps, checkerboards of extremes, tiny images",
           generate_shapes, InputKind::grey},
          {"grey_noise",
           "noise at widths 1..200, 509..514, 1023..1025 by heights 1 to 5 and 17; narrow ones "
           "up to 130 high",
           generate_noise, InputKind::grey}};
}

}  // namespace thinbench
