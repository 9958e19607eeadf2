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

// Numbers become levels of 16 bits.

/// A number as samples of T have it: 0.7 is equal to a float of 0.7, which is less by rounding.
template <class T>
double rounded(double number) {
  if constexpr (!std::is_same_v<T, float>) return number;
  const auto nearest = static_cast<float>(number);
  return std::isinf(nearest) ? number : static_cast<double>(nearest);
}

/// Calls `work` with each sample of colours, and whether it is a number of the picture: neither NaN
/// nor nodata nor transparent.
template <class T, class Work>
void for_each_colour(const Pixels& image, const Work& work) {
  const int colours = image.channels - (image.has_opacity() ? 1 : 0);
  const double none = image.nodata ? rounded<T>(*image.nodata) : std::nan("");
  const T* pixel = image.samples_of_row<T>(0);
  for (Index i = 0; i < image.width * image.height; ++i, pixel += image.channels) {
    const bool is_seen = colours == image.channels || pixel[colours] > 0;
    for (int k = 0; k < colours; ++k) {
      const auto number = static_cast<double>(pixel[k]);
      work(i * image.channels + k, number, is_seen && number != none && !std::isnan(number));
    }
  }
}

struct Numbers {
  double lowest = HUGE_VAL;
  double highest = -HUGE_VAL;
  bool are_levels = true;  // whole, of 16 bits

  template <class T>
  void add(T value) {
    const auto number = static_cast<double>(value);
    lowest = std::min(lowest, number);
    highest = std::max(highest, number);
    if constexpr (sizeof(T) > 2)
      are_levels = are_levels && number >= 0 && number <= 65535 && number == std::floor(number);
  }
};

template <class T>
Numbers numbers_of(const Pixels& image) {
  Numbers numbers;
  for_each_colour<T>(image, [&](Index, double number, bool counts) {
    if (counts) numbers.add(static_cast<T>(number));
  });
  if (numbers.lowest > numbers.highest) numbers.add(T{});  // there is none
  if (!std::isfinite(numbers.highest - numbers.lowest))
    throw DecodeError("it has infinite numbers");
  return numbers;
}

/// Levels of numbers: whole ones that fit remain, others are rounded. With a threshold, the levels
/// from `boundary` on are those of the numbers from the threshold on, and there is a lower level.
class Scale {
 public:
  Scale(const Numbers& numbers, std::optional<double> threshold) {
    const auto [lowest, highest, are_levels] = numbers;
    if (are_levels) {
      zero_ = std::min(lowest, 0.0);
      const double from = threshold ? std::ceil(*threshold) : zero_;
      if (from <= zero_ && threshold) zero_ -= 1;
      half_ = 0;
      if (threshold) boundary_ = std::clamp(from - zero_, 1.0, highest - zero_ + 1);
    }
    if (!are_levels || std::max(highest - zero_, boundary_) > kHighest) round(numbers, threshold);
    lowest_ = level(lowest);
  }

  [[nodiscard]] double first() const { return zero_ - step_ * base_; }
  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] int boundary() const { return static_cast<int>(boundary_); }
  [[nodiscard]] std::uint16_t level(double number) const {
    double level = std::floor((number - zero_) / step_ + half_) + base_;
    if (number < zero_) level = std::min(level, base_ - 1);  // however little it is
    return static_cast<std::uint16_t>(std::clamp(level, 0.0, kHighest));
  }
  /// Of what is no number: the least, and below any threshold.
  [[nodiscard]] std::uint16_t none() const {
    return boundary_ > 0 ? std::min(lowest_, static_cast<std::uint16_t>(boundary_ - 1)) : lowest_;
  }

 private:
  static constexpr double kHighest = 65535;

  void round(const Numbers& numbers, std::optional<double> threshold) {
    const auto& [lowest, highest, are_levels] = numbers;
    const bool is_low = threshold && *threshold <= lowest;
    const bool is_high = threshold && *threshold > highest;
    const double steps = !threshold ? kHighest : is_low || is_high ? kHighest - 1 : kHighest - 2;
    if (highest > lowest)
      step_ = std::max((highest - lowest) / steps, std::numeric_limits<double>::denorm_min());
    zero_ = lowest;
    half_ = 0.5;
    base_ = is_low ? 1 : 0;
    boundary_ = is_low ? 1 : is_high ? kHighest : 0;
    if (!threshold || is_low || is_high) return;
    zero_ = *threshold;
    half_ = 0;
    base_ = boundary_ = std::floor((*threshold - lowest) / step_) + 1;
  }

  // The level of a number is that of `zero_`, `base_`, and the number of steps from there.
  double zero_ = 0;
  double base_ = 0;
  double step_ = 1;
  double half_ = 0;      // to round to the nearest
  double boundary_ = 0;  // 0: there is none
  std::uint16_t lowest_ = 0;
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

template <class T>
Pixels in_levels(const Pixels& image, std::optional<double> threshold, GreyImage& grey) {
  if (threshold) threshold = rounded<T>(*threshold);
  const Scale scale(numbers_of<T>(image), threshold);
  Pixels levels = make_pixels(image.width, image.height, image.channels, SampleKind::u16);
  std::uint16_t* const to = levels.samples_of_row<std::uint16_t>(0);
  for_each_colour<T>(image, [&](Index i, double number, bool counts) {
    to[i] = counts ? scale.level(number) : scale.none();
  });
  if (image.has_opacity()) convert_opacity<T>(image, levels);
  grey.first = scale.first();
  grey.step = scale.step();
  if (threshold) grey.boundary = scale.boundary();
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

template <class T>
bool has_transparent_pixels(const Pixels& image) {
  const T* const all = image.samples_of_row<T>(0);
  for (Index i = image.channels - 1; i < image.samples(); i += image.channels) {
    if (all[i] < white<T>(image)) return true;
  }
  return false;
}

template <class T>
void flatten(const Pixels& image, Backdrop backdrop) {
  T* pixel = image.samples_of_row<T>(0);
  const std::uint64_t most = white<T>(image);
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
  if (choice.backdrop || !has_transparent_pixels<T>(image)) return {};
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
Pixels channel_of(Pixels image, Channel& channel, std::string& warning) {
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
  if (image.has_opacity()) {
    warning = opacity_warning<T>(image, choice);
    const Backdrop backdrop =
        choice.backdrop.value_or(image.shows_black ? Backdrop::black : Backdrop::as_stored);
    if (backdrop != Backdrop::as_stored) flatten<T>(image, backdrop);
  }
  return channel_of<T>(std::move(image), channel, warning);
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

Pixels opacity_of(const Pixels& image) {
  if (!image.has_opacity()) throw DecodeError("--channel alpha: it has no transparency");
  return for_type(image.kind, [&](auto sample) {
    return one_channel<decltype(sample)>(image, image.channels - 1);
  });
}

}  // namespace

GreyImage grey_of(Pixels image, const GreyChoice& choice, Channel& channel, std::string& warning) {
  GreyImage grey;
  grey.place = image.place;
  if (grey.place && choice.crop.height > 0) {
    auto& [a, b, c, d, e, f] = grey.place->transform;
    const auto x = static_cast<double>(choice.crop.x), y = static_cast<double>(choice.crop.y);
    c += a * x + b * y;
    f += d * x + e * y;
  }
  if (choice.opacity) image = opacity_of(image);
  if (image.kind >= SampleKind::i8) {
    image = for_type(image.kind, [&](auto sample) {
      return in_levels<decltype(sample)>(image, choice.threshold, grey);
    });
  }
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
  const auto highest = static_cast<unsigned>(range_of(image).highest);
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
  if (image.boundary) image.boundary = std::min((*image.boundary + (1 << shift) - 1) >> shift, 256);
  return image;
}

}  // namespace thinbench
