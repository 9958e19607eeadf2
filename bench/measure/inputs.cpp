#include "measure/inputs.hpp"

#include <regex>
#include <sstream>
#include <utility>

#include "harness/image_names.hpp"
#include "harness/test_images.hpp"
#include "images/image_file.hpp"
#include "scene/scene.hpp"
#include "support/usage.hpp"

namespace thinbench {
namespace {

constexpr std::uint64_t kNoiseSeed = 1999;
constexpr Index kMaxSide = 65536;
constexpr Index kMaxStrokeSide = 1024;

const Scene& scene() {
  static const Scene drawn = render_scene();
  return drawn;
}

ByteImage tiled(const ByteImage& tile, Index width, Index height) {
  ByteImage image(width, height);
  for (Index y = 0; y < height; ++y) {
    const std::uint8_t* source = tile.view().row(y % tile.height());
    std::uint8_t* row = image.view().row(y);
    for (Index x = 0; x < width; x += tile.width()) {
      std::copy_n(source, std::min(tile.width(), width - x), row + x);
    }
  }
  return image;
}

ByteImage enlarged(const ByteImage& original, Index times) {
  return image_by(original.width() * times, original.height() * times,
                  [&](Index x, Index y) { return original.at(x / times, y / times); });
}

ByteImage small_copy_of(const ByteImage& image) {
  constexpr Index across = 5;
  constexpr Index down = 16;
  return image_by((image.width() + across - 1) / across, (image.height() + down - 1) / down,
                  [&](Index x, Index y) { return image.at(x * across, y * down); });
}

ByteImage squares(Index size, Index side) {
  const auto inside = [side](Index place) {
    const Index phase = place % (2 * side);
    return phase >= side / 2 && phase < side / 2 + side;
  };
  return image_by(size, size, [&](Index x, Index y) { return inside(x) && inside(y) ? 255 : 0; });
}

/// Dots on a grid at 45 degrees, 17 pixels apart, that grow from the top left to the bottom right,
/// where what they leave are holes.
ByteImage halftone(Index size) {
  constexpr Index period = 24;  // of x + y and of x - y
  return image_by(size, size, [size](Index x, Index y) {
    const Index u = 2 * ((x + y) % period) - period;
    const Index v = 2 * ((x - y + size * period) % period) - period;
    return (u * u + v * v) * size < period * period * (x + y) ? 255 : 0;
  });
}

/// Lines of drawn characters with gaps between words, as a page of text scanned at 300 dpi.
ByteImage page(Index size) {
  constexpr Index side = 32, pitch = 48;
  const Index margin = size / 12, columns = (size - 2 * margin) / side;
  const Index lines = (size - 2 * margin) / pitch;
  const ByteImage characters = stroke_images(lines * columns, side, kNoiseSeed);
  ByteImage image(size, size);
  for (Index i = 0; i < lines * columns; ++i) {
    const Index line = i / columns, column = i % columns;
    if ((5 * line + column) % 7 == 0) continue;  // between words
    for (Index y = 0; y < side; ++y) {
      std::copy_n(characters.view().row(i * side + y), side,
                  image.view().row(margin + line * pitch + y) + margin + column * side);
    }
  }
  return image;
}

/// An image that is binary anyway.
TimedInput of_binary(const std::string& name, ByteImage image) {
  ByteImage grey = copy_of(image.view());
  return {name, std::move(image), std::move(grey)};
}

template <class Transform>
TimedInput of_scene(const std::string& name, const Transform& transform) {
  return {name, transform(scene().binary), transform(scene().grey)};
}

[[noreturn]] void reject(const std::string& name) {
  throw UsageError(
      "input '" + name +
      "': expected scene, square_N, tiled_N, enlarged_N, noise_N_PERCENT_BLOCK, squares_N_SIDE, "
      "halftone_N, page_N or strokes_SIDE_COUNT, with sides from 1 to " +
      std::to_string(kMaxSide));
}

struct DrawnName {
  std::string kind;
  std::vector<Index> numbers;
};

const std::regex& drawn_names() {
  static const std::regex names(
      "scene|(square|tiled|enlarged|halftone|page)_([0-9]{1,5})|noise_([0-9]{1,5})_([0-9]{1,3})_(["
      "0-9]{1,4})|"
      "squares_([0-9]{1,5})_([0-9]{1,5})|strokes_([0-9]{1,4})_([0-9]{1,5})");
  return names;
}

DrawnName parse_name(const std::string& name) {
  if (!std::regex_match(name, drawn_names())) reject(name);
  DrawnName parsed{name.substr(0, name.find('_')), {}};
  for (std::size_t at = name.find('_'); at != std::string::npos; at = name.find('_', at + 1)) {
    parsed.numbers.push_back(std::stol(name.substr(at + 1)));
  }
  return parsed;
}

bool in_limits(const DrawnName& name) {
  if (name.kind == "scene") return true;
  const bool scaled = name.kind == "tiled" || name.kind == "enlarged";
  const Index side = name.numbers.front() * (scaled ? scene().binary.width() : 1);
  if (side < 1 || side > kMaxSide) return false;
  if (name.kind == "strokes") return side <= kMaxStrokeSide && name.numbers[1] >= 1;
  if (name.kind == "squares") return name.numbers[1] >= 1;
  return name.kind != "noise" || (name.numbers[1] <= 100 && name.numbers[2] >= 1);
}

}  // namespace

TimedInput drawn_input(const std::string& name) {
  const auto [kind, numbers] = parse_name(name);
  if (!in_limits({kind, numbers})) reject(name);
  const Index n = numbers.empty() ? 1 : numbers.front();
  if (kind == "noise") {
    const int percent = static_cast<int>(numbers[1]);
    return of_binary(name, noise_image(n, n, percent, numbers[2], kNoiseSeed));
  }
  if (kind == "squares") return of_binary(name, squares(n, numbers[1]));
  if (kind == "halftone") return of_binary(name, halftone(n));
  if (kind == "page") return of_binary(name, page(n));
  if (kind == "strokes") return of_binary(name, stroke_images(numbers[1], n, kNoiseSeed));
  return of_scene(name, [drawn = kind, n](const ByteImage& image) {
    if (drawn == "square") return tiled(image, n, n);
    if (drawn == "enlarged") return enlarged(image, n);
    return tiled(image, n * image.width(), n * image.height());
  });
}

std::vector<TimedInput> timed_inputs(const InputChoice& choice, std::ostream* log) {
  std::vector<TimedInput> inputs;
  for (const std::string& path : choice.pictures) {
    std::ostringstream remarks;
    ByteImage grey = copy_of(read_grey(path, choice.binarise, remarks).view());  // aligned rows
    BinaryImage binary = binarise(copy_of(grey.view()), choice.binarise);
    print_remarks(path, binary, choice.binarise, remarks);
    if (log != nullptr) *log << remarks.str();
    std::string name = image_name(path, names_of(inputs), drawn_names());
    inputs.push_back({std::move(name), std::move(binary.image), std::move(grey)});
  }
  for (const std::string& name : choice.drawn) inputs.push_back(drawn_input(name));
  if (inputs.empty()) inputs.push_back(drawn_input("scene"));
  return inputs;
}

TimedInput small_copy(const TimedInput& input) {
  return {input.name + "_small", small_copy_of(input.binary), small_copy_of(input.grey)};
}

std::uint64_t pixel_hash(ConstImageView image) {
  std::uint64_t hash = 0xCBF29CE484222325;
  for (Index y = 0; y < image.height; ++y) {
    for (Index x = 0; x < image.width; ++x) hash = (hash ^ image.row(y)[x]) * 0x100000001B3;
  }
  return hash;
}

}  // namespace thinbench
