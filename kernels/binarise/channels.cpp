#include <algorithm>
#include <limits>
#include <string>

#include "binarise/histogram.hpp"
#include "core/byte_image.hpp"
#include "core/checks.hpp"
#include "core/variant.hpp"
#include "thinbench/binarise.hpp"

namespace thinbench {
namespace {

using detail::require;

template <class T>
T grey_of(const T* p) {  // 0.299, 0.587 and 0.114 of 2^15
  constexpr std::uint32_t red = 9798, green = 19235, blue = 3735;
  return static_cast<T>((red * p[0] + green * p[1] + blue * p[2] + (1U << 14)) >> 15);
}

template <class T>
T saturation_of(const T* p) {
  using Wide = std::conditional_t<sizeof(T) == 1, int, std::int64_t>;
  const Wide max = std::max({p[0], p[1], p[2]}), min = std::min({p[0], p[1], p[2]});
  constexpr Wide highest = std::numeric_limits<T>::max();
  return static_cast<T>(max == 0 ? 0 : (2 * highest * (max - min) + max) / (2 * max));
}

template <class T>
T value_of(const T* p) {
  return std::max({p[0], p[1], p[2]});
}

template <class T, class LevelOf>
void fill(const ColourView<T>& colours, const View<T>& to, const LevelOf& level_of) {
  for (Index y = 0; y < to.height; ++y) {
    const T* from = colours.data + y * colours.stride;
    T* const row = to.row(y);
    for (Index x = 0; x < to.width; ++x, from += colours.samples) row[x] = level_of(from);
  }
}

template <class T>
void write_channel(const ColourView<T>& colours, const View<T>& to, Channel channel) {
  switch (channel) {
    case Channel::red:
      return fill(colours, to, [](const T* p) { return p[0]; });
    case Channel::green:
      return fill(colours, to, [](const T* p) { return p[1]; });
    case Channel::blue:
      return fill(colours, to, [](const T* p) { return p[2]; });
    case Channel::saturation:
      return fill(colours, to, saturation_of<T>);
    case Channel::value:
      return fill(colours, to, value_of<T>);
    default:
      return fill(colours, to, grey_of<T>);
  }
}

template <class T>
bool has_colours(const ColourView<T>& colours) {
  for (Index y = 0; y < colours.height; ++y) {
    const T* p = colours.data + y * colours.stride;
    for (Index x = 0; x < colours.width; ++x, p += colours.samples) {
      if (p[0] != p[1] || p[1] != p[2]) return true;
    }
  }
  return false;
}

template <class T>
Channel best_channel(const ColourView<T>& colours, const View<T>& scratch) {
  Channel best = Channel::grey;
  double greatest = -1;
  for (std::size_t i = 0; i < kChannelNames.size() - 1; ++i) {
    write_channel(colours, scratch, static_cast<Channel>(i));
    const detail::Histogram counts = detail::histogram_of<T>(scratch);
    const double found = detail::separation(counts, detail::otsu_threshold(counts));
    if (found <= greatest) continue;
    greatest = found;
    best = static_cast<Channel>(i);
  }
  return best;
}

template <class T>
void check(const ColourView<T>& colours, const View<T>& destination, Channel channel) {
  detail::require_enumerator(channel, kChannelNames.size(), "channel");
  require(colours.samples == 3 || colours.samples == 4,
          "colours: expected 3 or 4 samples per pixel, got " + std::to_string(colours.samples));
  detail::require_size(colours.width, colours.height);
  detail::require_max_pixels(colours.width, colours.height);
  const detail::Memory from = {"colours",     colours.data,   sizeof(T),
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

template <class T>
Channel select(const ColourView<T>& colours, const View<T>& destination, Channel channel,
               const Execution& execution) {
  check(colours, destination, channel);
  detail::require_execution(execution);
  if (channel == Channel::grey || !has_colours(colours)) channel = Channel::grey;
  if (channel == Channel::automatic) channel = best_channel(colours, destination);
  write_channel(colours, destination, channel);
  return channel;
}

}  // namespace

Channel select_channel(ConstColourView colours, ImageView destination, Channel channel,
                       const Execution& execution) {
  return select(colours, destination, channel, execution);
}

Channel select_channel16(ColourView<std::uint16_t> colours, View<std::uint16_t> destination,
                         Channel channel, const Execution& execution) {
  return select(colours, destination, channel, execution);
}

}  // namespace thinbench
