#include "sweeps/input.hpp"

#include <stdexcept>

#include "harness/test_images.hpp"
#include "scene/scene.hpp"
#include "support/text.hpp"
#include "timing/inputs.hpp"

namespace thinbench {
namespace {

constexpr std::uint64_t kNoiseSeed = 1999;

ByteImage squares(Index width, Index height, Index side) {
  const auto inside = [side](Index place) {
    const Index phase = place % (2 * side);
    return phase >= side / 2 && phase < side / 2 + side;
  };
  ByteImage image(width, height);
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; inside(y) && x < width; ++x) image.at(x, y) = inside(x) ? 255 : 0;
  }
  return image;
}

ByteImage enlarged(const ByteImage& original, const SweepInput& input) {
  ByteImage image(input.width, input.height);
  for (Index y = 0; y < input.height; ++y) {
    for (Index x = 0; x < input.width; ++x) {
      image.at(x, y) = original.at(x / input.grain, y / input.grain);
    }
  }
  return image;
}

}  // namespace

std::string SweepInput::name() const {
  const std::string size = joined({std::to_string(width), std::to_string(height)}, "x");
  switch (picture) {
    case Picture::scene:
      return joined({"scene", size}, " ");
    case Picture::enlarged:
      return joined({"scene", size, "enlarged", std::to_string(grain), "times"}, " ");
    case Picture::squares:
      return joined({"squares", size, "of", std::to_string(grain)}, " ");
    case Picture::noise:
      return joined(
          {"noise", size, std::to_string(percent), "% in blocks of", std::to_string(grain)}, " ");
  }
  return {};
}

ByteImage make_input(const SweepInput& input, InputKind kind) {
  if (input.picture == Picture::scene) {
    static const Scene scene = render_scene();
    return tiled(kind == InputKind::grey ? scene.grey : scene.binary, input.width, input.height);
  }
  if (kind == InputKind::grey) throw std::logic_error("there is no grey " + input.name());
  if (input.picture == Picture::enlarged) return enlarged(render_scene().binary, input);
  if (input.picture == Picture::squares) return squares(input.width, input.height, input.grain);
  return noise_image(input.width, input.height, input.percent, input.grain, kNoiseSeed);
}

const ByteImage& InputStore::get(const SweepInput& input, InputKind kind) {
  const auto found = images_.find({input, kind});
  if (found != images_.end()) return found->second;
  if (bytes() + input.pixels() > most_) images_.clear();
  return images_.emplace(std::pair(input, kind), make_input(input, kind)).first->second;
}

std::int64_t InputStore::bytes() const {
  std::int64_t sum = 0;
  for (const auto& [key, image] : images_) sum += key.first.pixels();
  return sum;
}

}  // namespace thinbench
