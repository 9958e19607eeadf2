#include "timing/inputs.hpp"

#include <array>
#include <cstdio>
#include <regex>

#include "picture/picture.hpp"
#include "scene/scene.hpp"
#include "support/picture_names.hpp"

namespace thinbench {
namespace {

/// Never that of the scene or of a square of the series of sizes, on this run or another.
std::string name_of(const std::string& picture, const std::vector<TimedInput>& before) {
  static const std::regex reserved("scene|square_[0-9]+");
  return picture_name(picture, names_of(before), reserved);
}

}  // namespace

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

std::vector<TimedInput> timed_inputs(const InputChoice& choice) {
  const Scene scene = render_scene();
  std::vector<TimedInput> inputs;
  for (const std::string& path : choice.pictures) {
    ByteImage grey = read_grey(path);
    BinaryImage binary = binarise(copy_of(grey.view()), choice.binarise);
    if (choice.log != nullptr) print_remarks(path, binary, choice.binarise, *choice.log);
    inputs.push_back({name_of(path, inputs), std::move(binary.image), std::move(grey), false});
  }
  if (inputs.empty()) {
    inputs.push_back({"scene", copy_of(scene.binary.view()), copy_of(scene.grey.view()), false});
  }
  for (Index size = 64; size <= choice.largest_square; size *= 2) {
    inputs.push_back({"square_" + std::to_string(size), tiled(scene.binary, size, size),
                      tiled(scene.grey, size, size), true});
  }
  return inputs;
}

std::string pixel_hash(ConstImageView image) {
  std::uint64_t hash = 0xCBF29CE484222325;
  for (Index y = 0; y < image.height; ++y) {
    for (Index x = 0; x < image.width; ++x) hash = (hash ^ image.row(y)[x]) * 0x100000001B3;
  }
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

}  // namespace thinbench
