#include "timing/inputs.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <regex>

#include "picture/objects.hpp"
#include "picture/picture.hpp"
#include "scene/scene.hpp"

namespace thinbench {
namespace {

ByteImage tiled_square(const ByteImage& tile, Index size) {
  ByteImage image(size, size);
  for (Index y = 0; y < size; ++y) {
    for (Index x = 0; x < size; ++x) image.at(x, y) = tile.at(x % tile.width(), y % tile.height());
  }
  return image;
}

/// Whether the scene or a square of the series of sizes is called so, on this run or another.
bool is_reserved(const std::string& name) {
  static const std::regex reserved("scene|square_[0-9]+");
  return std::regex_match(name, reserved);
}

/// The file's name without folder and ending, made unique and fit for a row name.
std::string input_name(const std::string& path, const std::vector<TimedInput>& taken) {
  std::string stem = std::filesystem::path(path).stem().string();
  if (is_reserved(stem)) stem += "_picture";
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(taken.begin(), taken.end(),
                       [&](const TimedInput& input) { return input.name == name; });
  };
  std::string name = stem;
  for (int i = 2; is_taken(name); ++i) name = stem + "_" + std::to_string(i);
  return name;
}

}  // namespace

std::vector<TimedInput> timed_inputs(const InputChoice& choice) {
  const Scene scene = render_scene();
  std::vector<TimedInput> inputs;
  for (const std::string& path : choice.pictures) {
    ByteImage grey = read_grey(path);
    ByteImage objects = objects_of(copy_of(grey.view()));
    inputs.push_back({input_name(path, inputs), std::move(objects), std::move(grey), false});
  }
  if (inputs.empty()) {
    inputs.push_back({"scene", copy_of(scene.binary.view()), copy_of(scene.grey.view()), false});
  }
  for (Index size = 64; size <= choice.largest_square; size *= 2) {
    inputs.push_back({"square_" + std::to_string(size), tiled_square(scene.binary, size),
                      tiled_square(scene.grey, size), true});
  }
  return inputs;
}

std::string pixel_hash(ConstByteView image) {
  std::uint64_t hash = 0xCBF29CE484222325;
  for (Index y = 0; y < image.height; ++y) {
    for (Index x = 0; x < image.width; ++x) hash = (hash ^ image.row(y)[x]) * 0x100000001B3;
  }
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

}  // namespace thinbench
