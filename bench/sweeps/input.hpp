// The images of the sweeps: made when they are needed, from a recipe that a journal can name.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "harness/job.hpp"

namespace thinbench {

enum class Picture : std::uint8_t {
  noise,     // random blocks, see noise_image
  scene,     // the scene, laid out like tiles
  enlarged,  // the scene, every pixel a square of pixels
  squares,   // foreground squares as far apart as they are wide
};

struct SweepInput {
  Picture picture = Picture::scene;
  Index width = 0;
  Index height = 0;
  Index grain = 0;  // side of a block of noise, of a square or of an enlarged pixel (pixels)
  int percent = 0;  // of the noise's blocks that are foreground

  bool operator==(const SweepInput&) const = default;
  bool operator<(const SweepInput& other) const { return fields() < other.fields(); }
  [[nodiscard]] std::int64_t pixels() const { return width * height; }
  /// "noise 2048x2048 50 % in blocks of 4".
  [[nodiscard]] std::string name() const;

 private:
  [[nodiscard]] std::tuple<Picture, Index, Index, Index, int> fields() const {
    return {picture, width, height, grain, percent};
  }
};

/// Throws std::logic_error for grey noise, squares or enlargements: they are binary.
[[nodiscard]] ByteImage make_input(const SweepInput& input, InputKind kind);

/// Makes images and keeps them as long as they fit into a limit together.
class InputStore {
 public:
  explicit InputStore(std::int64_t most_bytes = std::int64_t{512} << 20) : most_(most_bytes) {}

  /// The image stays until the next call.
  const ByteImage& get(const SweepInput& input, InputKind kind);
  /// Of all images that are kept.
  [[nodiscard]] std::int64_t bytes() const;

 private:
  std::int64_t most_;
  std::map<std::pair<SweepInput, InputKind>, ByteImage> images_;
};

}  // namespace thinbench
