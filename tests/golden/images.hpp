// The images of the golden file, all drawn with integer arithmetic.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/test_images.hpp"
#include "scene/scene.hpp"
#include "support/made_image.hpp"

namespace thinbench::golden {

inline std::string sized(std::string_view name, Index width, Index height) {
  return std::string(name) + "_" + std::to_string(width) + "x" + std::to_string(height);
}

inline std::string seeded(const std::string& name, std::uint64_t seed) {
  return name + "_seed" + std::to_string(seed);
}

/// Collects images of one kind. A name holds all parameters of its image.
class Gallery {
 public:
  explicit Gallery(InputKind kind) : kind_(kind) {}

  void add(std::string name, ByteImage image) {
    images_.push_back({std::move(name), std::move(image), kind_});
  }
  /// Foreground where `contains` returns true.
  template <class Contains>
  void add_shape(std::string_view name, Index width, Index height, const Contains& contains) {
    add(sized(name, width, height),
        image_by(width, height, [&](Index x, Index y) { return contains(x, y) ? 255 : 0; }));
  }
  template <class Level>
  void add_levels(std::string_view name, Index width, Index height, const Level& level) {
    add(sized(name, width, height), image_by(width, height, level));
  }

  std::vector<TestImage> take() { return std::move(images_); }

 private:
  InputKind kind_;
  std::vector<TestImage> images_;
};

/// Parts touch the image border; twice the size of the test image, and strong noise.
inline Scene second_scene() {
  return render_scene({SceneKind::border_touching, 2, 320, true, 7});
}

struct Noise {
  Index width;
  Index height;
  int percent;
  Index granularity = 1;
};

/// Their places, counted from 1, are the seeds. The last two are large enough to run on several
/// threads.
constexpr Noise kNoise[] = {
    {1, 70, 60},     {2, 17, 70},          {3, 700, 85},    {31, 17, 50},  {31, 700, 70, 5},
    {63, 70, 85, 2}, {64, 48, 35},         {65, 70, 60, 3}, {127, 17, 97}, {128, 70, 65, 4},
    {200, 2, 50},    {511, 17, 80, 3},     {512, 70, 20},   {513, 1, 60},  {1030, 70, 50, 9},
    {4200, 40, 99},  {1100, 1000, 60, 12}, {1030, 1100, 99}};

inline void add_noise(Gallery& gallery) {
  std::uint64_t seed = 0;
  for (const auto& [width, height, percent, granularity] : kNoise) {
    const std::string blocks =
        granularity == 1 ? std::string() : "_blocks_of_" + std::to_string(granularity);
    ++seed;
    gallery.add(seeded(sized("noise_" + std::to_string(percent) + blocks, width, height), seed),
                noise_image(width, height, percent, granularity, seed));
  }
}

inline void add_strokes(Gallery& gallery) {
  for (const Index side : {28, 511}) {
    gallery.add(seeded(sized("strokes", side, side), 19), stroke_images(1, side, 19));
  }
}

/// Shapes that touch every side of the image.
inline void add_border_shapes(Gallery& gallery) {
  gallery.add_shape("frame", 13, 9,
                    [](Index x, Index y) { return x == 0 || y == 0 || x == 12 || y == 8; });
  gallery.add_shape("bars", 513, 70,
                    [](Index x, Index y) { return x < 5 || y < 5 || x >= 508 || y >= 65; });
  gallery.add_shape("cross", 65, 63,
                    [](Index x, Index y) { return std::abs(x - 32) < 5 || std::abs(y - 31) < 4; });
  gallery.add_shape("diamond", 127, 127,
                    [](Index x, Index y) { return std::abs(x - 63) + std::abs(y - 63) <= 63; });
  gallery.add_shape("rings", 201, 201, [](Index x, Index y) {
    return ((x - 100) * (x - 100) + (y - 100) * (y - 100)) / 900 % 2 == 0;
  });
}

inline void add_plain(Gallery& gallery) {
  for (const auto& [width, height] :
       {std::pair<Index, Index>{0, 0}, {0, 7}, {7, 0}, {1, 1}, {65, 33}, {200, 2}, {512, 40}}) {
    gallery.add_shape("foreground", width, height, [](Index, Index) { return true; });
  }
  gallery.add_shape("background", 64, 17, [](Index, Index) { return false; });
  gallery.add_shape("checkerboard", 64, 17, [](Index x, Index y) { return (x + y) % 2 == 0; });
}

inline std::vector<TestImage> binary_images() {
  Gallery gallery(InputKind::binary);
  gallery.add("test_image", std::move(render_scene().binary));
  gallery.add("second_scene", std::move(second_scene().binary));
  gallery.add("all_neighbourhoods_261x32", neighbourhood_sheet(5));
  // Foreground values other than 255.
  gallery.add("values_0_to_3_130x40_seed20", grey_noise_image(130, 40, 0, 3, 20));
  add_noise(gallery);
  add_strokes(gallery);
  add_border_shapes(gallery);
  add_plain(gallery);
  return gallery.take();
}

struct GreyNoise {
  Index width;
  Index height;
  std::uint8_t min_level;
  std::uint8_t max_level;
};

/// Their seeds follow those of the binary images.
constexpr GreyNoise kGreyNoise[] = {{1, 1, 0, 255},     {2, 3, 0, 255},    {5, 100, 0, 255},
                                    {31, 65, 118, 138}, {200, 70, 0, 255}, {513, 65, 90, 170},
                                    {1030, 17, 60, 255}};

inline void add_grey_noises(Gallery& gallery) {
  std::uint64_t seed = 20;
  for (const auto& [width, height, low, high] : kGreyNoise) {
    const std::string name = "grey_noise_" + std::to_string(low) + "_to_" + std::to_string(high);
    ++seed;
    gallery.add(seeded(sized(name, width, height), seed),
                grey_noise_image(width, height, low, high, seed));
  }
  const ByteImage blocks = grey_noise_image(92, 84, 0, 255, 28);
  gallery.add_levels("grey_noise_blocks_of_12_seed28", 1100, 1000,
                     [&](Index x, Index y) { return blocks.at(x / 12, y / 12); });
}

inline void add_ramps(Gallery& gallery) {
  gallery.add_levels("ramp_right", 512, 17, [](Index x, Index) { return x * 3 % 256; });
  gallery.add_levels("ramp_down", 63, 300, [](Index, Index y) { return y * 17 % 256; });
  gallery.add_levels("slope", 127, 70, [](Index x, Index y) { return (x * 5 + y * 7) % 256; });
  gallery.add_levels("steps", 64, 48,
                     [](Index x, Index y) { return 100 + x / 8 * 16 + y / 8 % 2 * 30; });
  gallery.add_levels("dots", 65, 33,
                     [](Index x, Index y) { return x % 7 == 3 && y % 5 == 2 ? 0 : 255; });
  gallery.add_levels("grey_rings", 201, 201, [](Index x, Index y) {
    return ((x - 100) * (x - 100) + (y - 100) * (y - 100)) / 900 % 2 * 190 + 30;
  });
  gallery.add_levels("white", 0, 0, [](Index, Index) { return 255; });
  gallery.add_levels("white", 33, 5, [](Index, Index) { return 255; });
}

inline std::vector<TestImage> grey_images() {
  Gallery gallery(InputKind::grey);
  gallery.add("grey_scene", std::move(render_scene().grey));
  gallery.add("second_grey_scene", std::move(second_scene().grey));
  add_grey_noises(gallery);
  add_ramps(gallery);
  return gallery.take();
}

/// All images; their names are unique.
inline std::vector<TestImage> golden_images() {
  std::vector<TestImage> images = binary_images();
  for (TestImage& grey : grey_images()) images.push_back(std::move(grey));
  return images;
}

}  // namespace thinbench::golden
