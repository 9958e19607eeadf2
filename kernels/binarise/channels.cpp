#include <algorithm>
#include <array>
#include <string>

#include "binarise/histogram.hpp"
#include "core/byte_image.hpp"
#include "core/checks.hpp"
#include "core/variant.hpp"
#include "thinbench/binarise.hpp"

namespace thinbench {
namespace {

using detail::require;

std::uint8_t byte(int value) {
  return static_cast<std::uint8_t>(value);
}

std::uint8_t grey_of(const std::uint8_t* p) {  // 0.299, 0.587 and 0.114 of 2^15
  return byte((9798 * p[0] + 19235 * p[1] + 3735 * p[2] + (1 << 14)) >> 15);
}

std::uint8_t saturation_of(const std::uint8_t* p) {
  const int max = std::max({p[0], p[1], p[2]});
  const int min = std::min({p[0], p[1], p[2]});
  return max == 0 ? byte(0) : byte((510 * (max - min) + max) / (2 * max));
}

std::uint8_t value_of(const std::uint8_t* p) {
  return std::max({p[0], p[1], p[2]});
}

template <class LevelOf>
void fill(const ConstColourView& colours, const ImageView& to, const LevelOf& level_of) {
  for (Index y = 0; y < to.height; ++y) {
    const std::uint8_t* from = colours.data + y * colours.stride;
    std::uint8_t* const row = to.row(y);
    for (Index x = 0; x < to.width; ++x, from += colours.samples) row[x] = level_of(from);
  }
}

void write_channel(const ConstColourView& colours, const ImageView& to, Channel channel) {
  switch (channel) {
    case Channel::red:
      return fill(colours, to, [](const std::uint8_t* p) { return p[0]; });
    case Channel::green:
      return fill(colours, to, [](const std::uint8_t* p) { return p[1]; });
    case Channel::blue:
      return fill(colours, to, [](const std::uint8_t* p) { return p[2]; });
    case Channel::saturation:
      return fill(colours, to, saturation_of);
    case Channel::value:
      return fill(colours, to, value_of);
    default:
      return fill(colours, to, grey_of);
  }
}

bool has_colours(const ConstColourView& colours) {
  for (Index y = 0; y < colours.height; ++y) {
    const std::uint8_t* p = colours.data + y * colours.stride;
    for (Index x = 0; x < colours.width; ++x, p += colours.samples) {
      if (p[0] != p[1] || p[1] != p[2]) return true;
    }
  }
  return false;
}

Channel best_channel(const ConstColourView& colours, const ImageView& scratch) {
  Channel best = Channel::grey;
  double greatest = -1;
  for (std::size_t i = 0; i < kChannelNames.size() - 1; ++i) {
    write_channel(colours, scratch, static_cast<Channel>(i));
    const detail::Histogram counts = detail::histogram_of(scratch);
    const double found = detail::separation(counts, detail::otsu_threshold(counts));
    if (found <= greatest) continue;
    greatest = found;
    best = static_cast<Channel>(i);
  }
  return best;
}

void check(const ConstColourView& colours, const ImageView& destination, Channel channel) {
  detail::require_enumerator(channel, kChannelNames.size(), "channel");
  require(colours.samples == 3 || colours.samples == 4,
          "colours: expected 3 or 4 bytes per pixel, got " + std::to_string(colours.samples));
  detail::require_size(colours.width, colours.height);
  detail::require_max_pixels(colours.width, colours.height);
  const detail::Memory from = {"colours",     colours.data,   1,
                               colours.width, colours.height, colours.samples * colours.width,
                               colours.stride};
  const detail::Memory to = detail::memory_of("destination", destination);
  detail::check(from);
  detail::check(to);
  require(!detail::overlap(from, to), "colours and destination overlap");
  require(colours.width == destination.width && colours.height == destination.height,
          "destination: expected " + detail::size_text(colours.width, colours.height) +
              " pixels, got " + detail::size_text(destination.width, destination.height));
}

}  // namespace

Channel select_channel(ConstColourView colours, ImageView destination, Channel channel,
                       const Execution& execution) {
  check(colours, destination, channel);
  detail::require_execution(execution);
  if (channel == Channel::grey || !has_colours(colours)) channel = Channel::grey;
  if (channel == Channel::automatic) channel = best_channel(colours, destination);
  write_channel(colours, destination, channel);
  return channel;
}

}  // namespace thinbench
