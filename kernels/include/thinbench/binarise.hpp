// Which pixels of a grey image are foreground, and which channel of a colour image is its grey.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "thinbench/enumeration.hpp"
#include "thinbench/export.h"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench {

enum class Foreground : std::uint8_t { automatic, bright, dark };

/// As options name them, in the order of the enumerators.
inline constexpr std::array<std::string_view, 3> kForegroundNames = {"auto", "bright", "dark"};

[[nodiscard]] constexpr std::string_view foreground_name(Foreground foreground) {
  return detail::entry_of(kForegroundNames, foreground, "foreground");
}

[[nodiscard]] constexpr std::optional<Foreground> foreground_from_name(std::string_view name) {
  return detail::value_named<Foreground>(kForegroundNames, name);
}

/// A threshold for each pixel from the mean of the window around it, of which only the part in the
/// image counts. Foreground is bright above mean + offset, or dark below mean - offset.
struct LocalThreshold {
  /// Side, odd, in [3, 65535]; 0: an eighth of the image's smaller side, at least 15.
  int window = 0;
  /// In grey levels, in [0, 255], of 16 bits in [0, 65535]; where there is none, 10, of 16 bits
  /// 10 / 255 of the difference of the highest and the lowest level in the image.
  std::optional<int> offset = std::nullopt;
};

struct Binarisation {
  /// automatic: the class that covers less of the image border, as the background surrounds what
  /// is shown; where both cover as much, the smaller class, and of equal ones the bright. With a
  /// local threshold: the side of their means to which pixels deviate farther, by the third moment.
  Foreground foreground = Foreground::automatic;
  /// Pixels are bright at this grey level and above, in [0, 255], of 16 bits in [0, 65535]; where
  /// there is none, from the level on that Otsu's method finds, the same as OpenCV's.
  std::optional<int> threshold = std::nullopt;
  /// Instead of a threshold for the whole image.
  std::optional<LocalThreshold> local = std::nullopt;
};

/// What was chosen, and what it was chosen from.
struct Binarised {
  Foreground foreground = Foreground::bright;  // bright or dark
  int threshold = 0;            // pixels are bright at this grey level and above, unless local
  double foreground_share = 0;  // of all pixels
  double separation = 0;        // the share of the variance that lies between the two classes

  /// Of pixels within a tenth of the classes' distance from the threshold.
  double undecided_share = 0;
  std::optional<int> only_level;  // where all pixels have this one
  bool was_binary = false;        // all grey levels were 0 or the highest, 255 or 65535
  int window = 0;                 // of the local threshold, if any
};

/// Writes 255 on foreground and 0 elsewhere. Views must have the same size and be the same image or
/// share no byte. An image without pixels is bright at level 1. Thread-safe for different
/// destinations. Throws std::invalid_argument for unsuitable views and for values out of range, and
/// std::bad_alloc. Nothing is written if it throws.
///
/// Sources: N. Otsu 1979, "A threshold selection method from gray-level histograms"; D. Bradley and
/// G. Roth 2007, "Adaptive thresholding using the integral image", for the local mean.
THINBENCH_API Binarised binarise(ConstImageView grey, ImageView destination,
                                 const Binarisation& request = {}, const Execution& execution = {});

/// The same for grey levels of 16 bits. Views share no byte.
THINBENCH_API Binarised binarise16(View<const std::uint16_t> grey, ImageView destination,
                                   const Binarisation& request = {},
                                   const Execution& execution = {});

/// What of a colour becomes its grey level: 0.299 red + 0.587 green + 0.114 blue, one of the three,
/// 255 (max - min) / max or max of the three (65535 for 255 in 16 bits); automatic: that of these
/// whose two classes by Otsu's method have the greatest separation, of equal ones the first.
enum class Channel : std::uint8_t { grey, red, green, blue, saturation, value, automatic };

/// As options name them, in the order of the enumerators.
inline constexpr std::array<std::string_view, 7> kChannelNames = {
    "grey", "red", "green", "blue", "saturation", "value", "auto"};

[[nodiscard]] constexpr std::string_view channel_name(Channel channel) {
  return detail::entry_of(kChannelNames, channel, "channel");
}

[[nodiscard]] constexpr std::optional<Channel> channel_from_name(std::string_view name) {
  return detail::value_named<Channel>(kChannelNames, name);
}

/// Pixels of 3 or 4 samples: red, green, blue and what is ignored. The stride is in samples.
template <class T>
struct ColourView {
  const T* data = nullptr;
  Index width = 0;
  Index height = 0;
  Index stride = 0;
  int samples = 3;
};
using ConstColourView = ColourView<std::uint8_t>;

/// Writes a channel of a colour image and returns which. An image whose colours are all grey gives
/// these grey levels, whatever the channel; that counts as Channel::grey. Views must have the same
/// size and share no byte; at most 2^40 pixels; otherwise as binarise().
THINBENCH_API Channel select_channel(ConstColourView colours, ImageView destination,
                                     Channel channel, const Execution& execution = {});

/// The same for samples of 16 bits.
THINBENCH_API Channel select_channel16(ColourView<std::uint16_t> colours,
                                       View<std::uint16_t> destination, Channel channel,
                                       const Execution& execution = {});

}  // namespace thinbench
