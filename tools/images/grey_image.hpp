// Grey levels of image files, of 8 or 16 bits.
#pragma once

#include <optional>
#include <string>

#include "images/pixels.hpp"
#include "thinbench/binarise.hpp"

namespace thinbench {

/// A part of an image; with no height, the whole image.
struct Crop {
  Index x = 0;
  Index y = 0;
  Index width = 0;
  Index height = 0;
};

/// What shows through where an image is transparent.
enum class Backdrop : std::uint8_t { as_stored, black, white };

/// What of an image becomes its grey levels.
struct GreyChoice {
  Channel channel = Channel::grey;
  bool opacity = false;                             // instead of a channel
  std::optional<Backdrop> backdrop = std::nullopt;  // unset: by the format
  Crop crop = {};
  double blur = 0;  // standard deviation of a Gaussian filter, in pixels; 0: none
  /// Numbers below this one get lower levels than the others.
  std::optional<double> threshold = std::nullopt;
};

/// Grey levels, and what they stand for in the file: first + step * level.
struct GreyImage {
  ByteImage bytes;                                // of 8 bits
  detail::AlignedArray<std::uint16_t> deep = {};  // or of 16, without gaps
  Index width = 0;
  Index height = 0;
  double first = 0;
  double step = 1;
  std::optional<int> boundary = std::nullopt;  // the level at which GreyChoice::threshold begins
  std::optional<GeoReference> place = std::nullopt;

  GreyImage() = default;
  explicit GreyImage(ByteImage levels)
      : bytes(std::move(levels)), width(bytes.width()), height(bytes.height()) {}

  [[nodiscard]] bool is_deep() const { return deep != nullptr; }
  [[nodiscard]] View<std::uint16_t> deep_view() const { return {deep.get(), width, height}; }
  /// The highest level that there can be.
  [[nodiscard]] int highest() const { return is_deep() ? 65535 : 255; }
};

struct LevelRange {
  int lowest;
  int highest;
};

/// The levels that an image has, which has pixels.
[[nodiscard]] LevelRange range_of(const GreyImage& image);

/// The grey levels of a decoded image, and what the user should know about transparency. `channel`
/// becomes the one that was chosen. Throws DecodeError where there is no such part or channel.
[[nodiscard]] GreyImage grey_of(Pixels image, const GreyChoice& choice, Channel& channel,
                                std::string& warning);

[[nodiscard]] GreyImage copy_of(const GreyImage& image);

/// Levels of 8 bits: those of 16 divided by the least power of two that makes all fit.
[[nodiscard]] GreyImage in_bytes(GreyImage image);

}  // namespace thinbench
