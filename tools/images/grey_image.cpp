#include "images/grey_image.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "images/blur.hpp"

namespace thinbench {
namespace {

template <class T>
constexpr std::uint32_t kMax = std::numeric_limits<T>::max();

/// The memory of decoded samples, as an image.
ByteImage adopted(Pixels& image) {
  std::uint8_t* const data = image.bytes.release();
  return {{data, image.width, image.height}, [](void* memory) { detail::give_block(memory); }};
}

// Numbers of 32 bits become levels of 16.

struct Numbers {
  double lowest = HUGE_VAL;
  double highest = -HUGE_VAL;
  bool are_levels = true;  // whole, of 16 bits

  void add(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
    are_levels = are_levels && value >= 0 && value <= 65535 && value == std::floor(value);
  }
};

/// Of the colours where they are seen, and the boundary.
template <class T>
Numbers numbers_of(const Pixels& image, std::optional<T> boundary) {
  Numbers numbers;
  const T* pixel = image.samples_of_row<T>(0);
  const int colours = image.channels - (image.has_opacity() ? 1 : 0);
  for (Index i = 0; i < image.width * image.height; ++i, pixel += image.channels) {
    if (colours < image.channels && !(pixel[colours] > 0)) continue;
    for (int k = 0; k < colours; ++k) {
      if (const auto value = static_cast<double>(pixel[k]); !std::isnan(value)) numbers.add(value);
    }
  }
  if (numbers.lowest > numbers.highest) numbers.add(0);  // there is none
  if (!std::isfinite(numbers.highest - numbers.lowest))
    throw DecodeError("it has infinite numbers");
  if (boundary) numbers.add(static_cast<double>(*boundary));
  return numbers;
}

/// Levels that are numbers remain; what is not a number counts as the lowest.
template <class T>
class Scale {
 public:
  Scale(const Numbers& numbers, std::optional<T> boundary) {
    if (numbers.are_levels) return;
    first_ = numbers.lowest;
    if (numbers.highest > numbers.lowest) step_ = (numbers.highest - numbers.lowest) / 65535;
    if (!boundary) return;
    step_ *= 65535.0 / 65533;  // for a level below the boundary and one that it begins
    const auto zero = static_cast<double>(*boundary);
    level_of_zero_ = std::floor((zero - first_) / step_) + 1;
    zero_ = zero;
    first_ = zero - step_ * level_of_zero_;
  }

  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double step() const { return step_; }
  /// The lowest level of numbers from the boundary on.
  [[nodiscard]] std::optional<int> boundary() const {
    return zero_ ? std::optional(static_cast<int>(level_of_zero_)) : std::nullopt;
  }
  [[nodiscard]] std::uint16_t level(T value) const {
    const auto number = static_cast<double>(value);
    const double level = zero_ ? std::floor((number - *zero_) / step_) + level_of_zero_
                               : std::round((number - first_) / step_);
    return level >= 0 ? static_cast<std::uint16_t>(std::min(level, 65535.0)) : std::uint16_t{0};
  }

 private:
  double first_ = 0;
  double step_ = 1;
  std::optional<double> zero_;  // the boundary, at which a level begins
  double level_of_zero_ = 0;
};

/// Opacity becomes levels of which 65535 is opaque, as is the greatest opacity of the image.
template <class T>
void convert_opacity(const Pixels& image, const Pixels& levels) {
  const int at = image.channels - 1;
  const T* const from = image.samples_of_row<T>(0);
  std::uint16_t* const to = levels.samples_of_row<std::uint16_t>(0);
  double opaque = 0;
  for (Index i = at; i < image.samples(); i += image.channels)
    opaque = std::max(opaque, static_cast<double>(from[i]));
  for (Index i = at; i < image.samples(); i += image.channels) {
    const double share = static_cast<double>(from[i]) / opaque;
    to[i] = share > 0 ? static_cast<std::uint16_t>(std::round(share * 65535)) : std::uint16_t{0};
  }
}

/// What samples are compared with: 0.7 is equal to a sample of 0.7, though that is less by
/// rounding.
template <class T>
T nearest(double number) {
  using Limits = std::numeric_limits<T>;
  const double whole = std::is_integral_v<T> ? std::ceil(number) : number;
  return static_cast<T>(
      std::clamp(whole, static_cast<double>(Limits::lowest()), static_cast<double>(Limits::max())));
}

template <class T>
Pixels in_levels(const Pixels& image, std::optional<double> number, GreyImage& grey) {
  std::optional<T> boundary;
  if (number) boundary = nearest<T>(*number);
  const Scale<T> scale(numbers_of<T>(image, boundary), boundary);
  Pixels levels = make_pixels(image.width, image.height, image.channels, SampleKind::u16);
  const T* const from = image.samples_of_row<T>(0);
  std::transform(from, from + image.samples(), levels.samples_of_row<std::uint16_t>(0),
                 [&scale](T value) { return scale.level(value); });
  if (image.has_opacity()) convert_opacity<T>(image, levels);
  grey.first = scale.first();
  grey.step = scale.step();
  grey.boundary = scale.boundary();
  levels.is_premultiplied = image.is_premultiplied;
  levels.shows_black = image.shows_black;
  return levels;
}

// Transparency.

/// The level of white.
template <class T>
std::uint64_t white(const Pixels& image) {
  return image.highest > 0 ? image.highest : kMax<T>;
}

/// The opacity of what is opaque.
template <class T>
std::uint64_t opaque(const Pixels& image) {
  return image.opaque > 0 ? image.opaque : white<T>(image);
}

template <class T>
bool has_transparent_pixels(const Pixels& image) {
  const T* const all = image.samples_of_row<T>(0);
  for (Index i = image.channels - 1; i < image.samples(); i += image.channels) {
    if (all[i] < opaque<T>(image)) return true;
  }
  return false;
}

template <class T>
void flatten(const Pixels& image, Backdrop backdrop) {
  T* pixel = image.samples_of_row<T>(0);
  const std::uint64_t most = opaque<T>(image);
  const int colours = image.channels - 1;
  for (Index i = 0; i < image.width * image.height; ++i, pixel += image.channels) {
    const std::uint64_t opacity = std::min<std::uint64_t>(pixel[colours], most);
    const std::uint64_t rest = most - opacity;
    for (int k = 0; k < colours; ++k) {
      std::uint64_t level = pixel[k];
      if (!image.is_premultiplied) level = (level * opacity + most / 2) / most;
      if (backdrop == Backdrop::white)
        level = std::min(level + rest * white<T>(image) / most, white<T>(image));
      pixel[k] = static_cast<T>(level);
    }
  }
}

/// Without what is not needed: the opacity of grey, or all but that.
template <class T>
Pixels one_channel(const Pixels& image, int channel) {
  Pixels levels = make_pixels(image.width, image.height, 1, image.kind);
  const T* const from = image.samples_of_row<T>(0) + channel;
  T* const to = levels.samples_of_row<T>(0);
  for (Index i = 0; i < image.width * image.height; ++i) to[i] = from[i * image.channels];
  return levels;
}

template <class T>
std::string opacity_warning(const Pixels& image, const GreyChoice& choice) {
  if (choice.opacity || choice.backdrop || !has_transparent_pixels<T>(image)) return {};
  return std::string("the image is transparent in places; ") +
         (image.shows_black ? "there it counts as black"
                            : "the colours stored there count as if it were opaque") +
         "; --background black or white, or --channel alpha, takes it otherwise";
}

// What is left has one or three channels, perhaps opacity, and is of T.

/// Whether all pixels are equal, opacity aside.
template <class T>
bool is_even(const Pixels& image) {
  const T* const all = image.samples_of_row<T>(0);
  for (Index i = 0; i < image.samples(); i += image.channels) {
    if (!std::equal(all, all + std::min(image.channels, 3), all + i)) return false;
  }
  return true;
}

template <class T>
Pixels channel_of(Pixels image, const GreyChoice& choice, Channel& channel, std::string& warning) {
  if (choice.opacity) return one_channel<T>(image, image.channels - 1);
  if (image.channels <= 2) channel = Channel::grey;
  if (image.channels == 1) return image;
  if (image.channels == 2) return one_channel<T>(image, 0);
  Pixels levels = make_pixels(image.width, image.height, 1, image.kind);
  const ColourView<T> colours = {image.samples_of_row<T>(0), image.width, image.height,
                                 image.width * image.channels, image.channels};
  const View<T> to(levels.samples_of_row<T>(0), image.width, image.height);
  if constexpr (sizeof(T) == 1) {
    channel = select_channel(colours, to, channel);
  } else {
    channel = select_channel16(colours, to, channel);
  }
  if (channel == Channel::grey && is_even<T>(levels) && !is_even<T>(image)) {
    if (!warning.empty()) warning += "; ";
    warning += "its colours have the same grey level; --channel auto tells them apart";
  }
  return levels;
}

template <class T>
Pixels levels_of(Pixels image, const GreyChoice& choice, Channel& channel, std::string& warning) {
  if (choice.opacity && !image.has_opacity()) {
    throw DecodeError("--channel alpha: it has no transparency");
  }
  if (image.has_opacity()) {
    warning = opacity_warning<T>(image, choice);
    const Backdrop backdrop =
        choice.backdrop.value_or(image.shows_black ? Backdrop::black : Backdrop::as_stored);
    if (!choice.opacity && backdrop != Backdrop::as_stored) flatten<T>(image, backdrop);
  }
  return channel_of<T>(std::move(image), choice, channel, warning);
}

Pixels cropped(Pixels image, const Crop& crop) {
  if (crop.x + crop.width > image.width || crop.y + crop.height > image.height) {
    throw DecodeError(fmt::format("--crop {},{},{}x{} is not inside the image of {} x {} pixels",
                                  crop.x, crop.y, crop.width, crop.height, image.width,
                                  image.height));
  }
  Pixels part = make_pixels(crop.width, crop.height, 1, image.kind);
  for (Index y = 0; y < crop.height; ++y) {
    std::copy_n(image.row(crop.y + y) + crop.x * sample_bytes(image.kind), part.row_bytes(),
                part.row(y));
  }
  return part;
}

}  // namespace

GreyImage grey_of(Pixels image, const GreyChoice& choice, Channel& channel, std::string& warning) {
  GreyImage grey;
  grey.first = image.first;
  grey.place = image.place;
  if (grey.place && choice.crop.height > 0) {
    auto& [a, b, c, d, e, f] = grey.place->transform;
    const auto x = static_cast<double>(choice.crop.x), y = static_cast<double>(choice.crop.y);
    c += a * x + b * y;
    f += d * x + e * y;
  }
  if (image.kind == SampleKind::u32) image = in_levels<std::uint32_t>(image, choice.boundary, grey);
  if (image.kind == SampleKind::f32) image = in_levels<float>(image, choice.boundary, grey);
  const bool is_deep = image.kind == SampleKind::u16;
  image = is_deep ? levels_of<std::uint16_t>(std::move(image), choice, channel, warning)
                  : levels_of<std::uint8_t>(std::move(image), choice, channel, warning);
  if (choice.crop.height > 0) image = cropped(std::move(image), choice.crop);
  if (choice.blur > 0) blur(image, choice.blur);
  grey.width = image.width;
  grey.height = image.height;
  if (is_deep) {
    grey.deep.reset(reinterpret_cast<std::uint16_t*>(image.bytes.release()));
  } else {
    grey.bytes = adopted(image);
  }
  return grey;
}

LevelRange range_of(const GreyImage& image) {
  const auto range = [&image](auto view) {
    LevelRange found = {65535, 0};
    for (Index y = 0; y < image.height; ++y) {
      const auto [low, high] = std::minmax_element(view.row(y), view.row(y) + view.width);
      found = {std::min<int>(found.lowest, *low), std::max<int>(found.highest, *high)};
    }
    return found;
  };
  return image.is_deep() ? range(image.deep_view()) : range(image.bytes.view());
}

GreyImage copy_of(const GreyImage& image) {
  GreyImage copy;
  if (image.is_deep()) {
    const auto count = static_cast<std::size_t>(image.width * image.height);
    copy.deep = detail::make_uninitialised<std::uint16_t>(count);
    std::copy_n(image.deep.get(), count, copy.deep.get());
  } else {
    copy.bytes = copy_of(image.bytes.view());
  }
  copy.width = image.width;
  copy.height = image.height;
  copy.first = image.first;
  copy.step = image.step;
  copy.boundary = image.boundary;
  copy.place = image.place;
  return copy;
}

GreyImage in_bytes(GreyImage image) {
  if (!image.is_deep()) return image;
  const auto highest =
      static_cast<unsigned>(std::max(range_of(image).highest, image.boundary.value_or(0)));
  const int shift = std::max(0, static_cast<int>(std::bit_width(highest)) - 8);
  image.bytes = ByteImage(image.width, image.height);
  for (Index y = 0; y < image.height; ++y) {
    const std::uint16_t* const from = image.deep_view().row(y);
    std::transform(
        from, from + image.width, image.bytes.view().row(y),
        [shift](std::uint16_t level) { return static_cast<std::uint8_t>(level >> shift); });
  }
  image.deep.reset();
  image.step *= 1 << shift;
  if (image.boundary) image.boundary = std::min((*image.boundary + (1 << shift) - 1) >> shift, 255);
  return image;
}

}  // namespace thinbench
