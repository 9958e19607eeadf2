#include "harness/test_images.hpp"

#include <array>
#include <numeric>
#include <utility>

#include "harness/splitmix64.hpp"

namespace thinbench {
namespace {

constexpr std::uint8_t kForeground = 255;

struct Noise {
  int percent;
  Index granularity;
};
constexpr std::array kNoises = {Noise{50, 1}, Noise{85, 1}, Noise{97, 1}, Noise{60, 2},
                                Noise{20, 1}, Noise{65, 4}, Noise{80, 3}, Noise{50, 9}};

TestImage noise(Index width, Index height, const Noise& noise, std::uint64_t seed) {
  std::string name = "noise " + std::to_string(width) + " x " + std::to_string(height) + ", " +
                     std::to_string(noise.percent) + " % in blocks of " +
                     std::to_string(noise.granularity) + ", seed " + std::to_string(seed);
  return {std::move(name), noise_image(width, height, noise.percent, noise.granularity, seed)};
}

std::vector<Index> awkward_widths() {
  std::vector<Index> widths(200);
  std::iota(widths.begin(), widths.end(), Index{1});
  for (const Index width : {509, 510, 511, 512, 513, 514, 515, 1023, 1024, 1025}) {
    widths.push_back(width);
  }
  return widths;
}

void generate_sizes(const TestImageSink& sink) {
  std::uint64_t seed = 1;
  for (const Index width : awkward_widths()) {
    for (const Index height : {1, 2, 3, 17, 64}) {
      // Three of the eight kinds a size, in turn: all kinds meet all residues of the width.
      for (int i = 0; i < 3; ++i, ++seed) sink(noise(width, height, kNoises[seed % 8], seed));
    }
  }
}

/// The images of 4096 numbers, 64 to a row. Cells are 7 pixels apart, so that they meet every phase
/// of a byte and no neighbour that two cells share.
ByteImage four_by_four_sheet(std::uint64_t first) {
  constexpr Index pitch = 7;
  ByteImage sheet(64 * pitch, 64 * pitch);
  for (std::uint64_t cell = 0; cell < 4096; ++cell) {
    const Index left = static_cast<Index>(cell % 64) * pitch;
    const Index top = static_cast<Index>(cell / 64) * pitch;
    for (int bit = 0; bit < 16; ++bit) {
      const bool set = ((first + cell) >> bit & 1) != 0;
      sheet.at(left + bit % 4, top + bit / 4) = set ? kForeground : 0;
    }
  }
  return sheet;
}

/// All of them on sheets, and some alone, where they touch the image border.
void generate_four_by_four(const TestImageSink& sink) {
  for (std::uint64_t first = 0; first < 65536; first += 4096) {
    sink({"4 x 4, bits from " + std::to_string(first), four_by_four_sheet(first)});
  }
  for (std::uint64_t bits = 0; bits < 65536; bits += 257) {
    sink({"4 x 4, bits " + std::to_string(bits), image_of_bits(4, 4, bits)});
  }
}

void generate_sheets(const TestImageSink& sink) {
  for (Index phase = 0; phase < 64; ++phase) {
    sink({"all neighbourhoods from column " + std::to_string(phase), neighbourhood_sheet(phase)});
  }
}

void generate_tiles(const TestImageSink& sink) {
  std::uint64_t seed = 1000;
  for (const auto& [width, height] : {std::pair<Index, Index>{130, 127},
                                      {512, 150},
                                      {600, 100},
                                      {40, 1100},
                                      {4200, 40},
                                      {4160, 20},
                                      {8320, 18},
                                      {66000, 3}}) {
    sink(noise(width, height, {99, 1}, ++seed));
    sink(noise(width, height, {70, 12}, ++seed));
  }
  sink(noise(65551, 17, {70, 12}, ++seed));  // wider than 16 bits, two rows of tiles
}

ByteImage filled(Index width, Index height, std::uint8_t value) {
  return image_by(width, height, [value](Index, Index) { return value; });
}

/// Foreground bars of growing thickness along all four sides, so that shapes run into the border.
ByteImage bars_on_border(Index width, Index height, Index thickness) {
  return image_by(width, height, [&](Index x, Index y) {
    const bool edge =
        x < thickness || y < thickness || x >= width - thickness || y >= height - thickness;
    return edge ? kForeground : 0;
  });
}

void generate_shapes(const TestImageSink& sink) {
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0},
                                      {0, 7},
                                      {7, 0},
                                      {1, 1},
                                      {64, 64},
                                      {65, 33},
                                      {510, 40},
                                      {512, 40},
                                      {513, 40},
                                      {700, 90}}) {
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    sink({"background " + size, filled(width, height, 0)});
    sink({"foreground " + size, filled(width, height, kForeground)});
    for (const Index thickness : {1, 2, 5, 12}) {
      sink({"bars of " + std::to_string(thickness) + " on the border of " + size,
            bars_on_border(width, height, thickness)});
    }
  }
}

/// Whether a pixel of an image of this size is foreground.
using Contains = bool (*)(Index x, Index y, Index width, Index height);

struct Pattern {
  const char* name;
  Contains contains;
};

TestImage pattern(const Pattern& pattern, Index width, Index height) {
  ByteImage image = image_by(width, height, [&](Index x, Index y) {
    return pattern.contains(x, y, width, height) ? kForeground : 0;
  });
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  return {std::string(pattern.name) + " " + size, std::move(image)};
}

/// One object: a line that winds to the centre, with one pixel between its turns.
ByteImage spiral(Index side) {
  ByteImage image(side, side);
  Index x = -1, y = 0, dx = 1, dy = 0;
  for (Index length = side, turns = 0; length > 0; ++turns) {
    for (Index i = 0; i < length; ++i) image.at(x += dx, y += dy) = kForeground;
    if (turns == 0) {
      length = side - 1;
    } else if (turns % 2 == 0) {
      length -= 2;
    }
    dx = -std::exchange(dy, dx);
  }
  return image;
}

/// Awkward for runs and for strips of rows: runs that join late, sums and coordinates that need
/// more than 16 bits, and more regions than 16 bits number.
void generate_patterns(const TestImageSink& sink) {
  constexpr std::array<Pattern, 10> patterns = {{
      {"checkerboard", [](Index x, Index y, Index, Index) { return (x + y) % 2 == 0; }},
      {"slanted checkerboard", [](Index x, Index y, Index, Index) { return (x + y / 2) % 2 == 0; }},
      {"slanted stripes", [](Index x, Index y, Index, Index) { return (x + y) % 3 != 0; }},
      {"comb", [](Index x, Index y, Index, Index height) { return x % 2 == 0 || y == height - 1; }},
      {"hanging comb", [](Index x, Index y, Index, Index) { return x % 2 == 0 || y == 0; }},
      {"meander", [](Index x, Index y, Index,
                     Index height) { return x % 4 == 0 || y == (x % 8 == 0 ? 0 : height - 1); }},
      {"comb of rows",
       [](Index x, Index y, Index width, Index) { return y % 2 == 0 || x == width - 1; }},
      {"meander of rows", [](Index x, Index y, Index width,
                             Index) { return y % 4 == 0 || x == (y % 8 < 4 ? 0 : width - 1); }},
      {"bricks", [](Index x, Index y, Index, Index) { return x / 64 % 2 == y / 2 % 2; }},
      {"gaps at ends of words",
       [](Index x, Index y, Index, Index) { return (x + 1) % 64 > 1 || y % 3 == 0; }},
  }};
  for (const Index width : {1, 2, 3, 31, 63, 64, 65, 127, 128, 129, 193, 511, 512, 513, 577}) {
    for (const Index height : {1, 2, 6, 13}) {
      for (const Pattern& one : patterns) sink(pattern(one, width, height));
    }
  }
  for (const Index side : {1, 2, 3, 5, 31, 64, 65, 130}) {
    sink({"spiral of " + std::to_string(side), spiral(side)});
  }
  const Pattern frame = {"frame with a bar", [](Index x, Index y, Index width, Index height) {
                           return x == 0 || y == 0 || x == width - 1 || y == height - 1 ||
                                  x == width / 2;
                         }};
  for (const auto& [width, height] :
       {std::pair<Index, Index>{20000, 60}, {65534, 5}, {70000, 4}, {9, 3000}}) {
    sink(pattern(frame, width, height));
  }
  sink(pattern({"dots", [](Index x, Index y, Index, Index) { return x % 2 == 1 && y % 2 == 1; }},
               701, 523));
  sink(pattern({"lattice", [](Index x, Index y, Index, Index) { return x % 2 == 0 || y % 2 == 0; }},
               701, 523));
}

}  // namespace

ByteImage noise_image(Index width, Index height, int percent, Index granularity,
                      std::uint64_t seed) {
  return image_by(width, height, [&](Index x, Index y) {
    const auto block = static_cast<std::uint64_t>((y / granularity) << 32 | (x / granularity));
    const bool set =
        splitmix64(splitmix64(seed) ^ block) % 100 < static_cast<std::uint64_t>(percent);
    return set ? kForeground : 0;
  });
}

ByteImage image_of_bits(Index width, Index height, std::uint64_t bits) {
  return image_by(width, height, [&](Index x, Index y) {
    return (bits >> (y * width + x) & 1) != 0 ? kForeground : 0;
  });
}

ByteImage neighbourhood_sheet(Index phase) {
  constexpr Index cells_in_row = 64;
  ByteImage image(phase + 4 * cells_in_row, 4 * 512 / cells_in_row);
  for (Index code = 0; code < 512; ++code) {
    const Index left = phase + 4 * (code % cells_in_row);
    const Index top = 4 * (code / cells_in_row);
    for (Index i = 0; i < 9; ++i) {
      image.at(left + i % 3, top + i / 3) = (code >> i & 1) != 0 ? kForeground : 0;
    }
  }
  return image;
}

const std::vector<TestImageSet>& test_image_sets() {
  static const std::vector<TestImageSet> binary = {
      {"shapes", "empty, background, foreground and border-touching images", generate_shapes},
      {"sheets", "all 512 neighbourhoods at every phase of a word", generate_sheets},
      {"sizes", "widths 1..200, 509..515, 1023..1025 by heights 1, 2, 3, 17, 64", generate_sizes},
      {"tiles", "tiles at rest, bands shared between threads", generate_tiles},
      {"patterns", "runs that join late; more than 16 bits count", generate_patterns},
      {"four_by_four", "all 65,536 images of 4 x 4 pixels", generate_four_by_four},
  };
  static const std::vector<TestImageSet> sets = [] {
    std::vector<TestImageSet> all = binary;
    for (TestImageSet& set : grey_image_sets()) all.push_back(std::move(set));
    return all;
  }();
  return sets;
}

}  // namespace thinbench
