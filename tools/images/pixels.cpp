#include "images/pixels.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

namespace thinbench {

Index bytes_of_rows(Index width, Index height, Index bits_per_pixel) {
  const auto product = [](Index a, Index b) {
    return b > 0 && a > INT64_MAX / b ? INT64_MAX : a * b;
  };
  const Index bits = product(width, bits_per_pixel);
  return product(bits / 8 + (bits % 8 != 0 ? 1 : 0), height);
}

namespace {

constexpr Index kMaxPackedPixels = Index{1} << 40;

/// What the environment allows, at most `most`.
Index allowed_pixels(Index most) {
  const char* const text = std::getenv(kMaxPixelsVariable);
  if (text == nullptr) return most;
  Index pixels = 0;
  const char* const end = text + std::strlen(text);
  const auto result = std::from_chars(text, end, pixels);
  if (result.ec == std::errc() && result.ptr == end && pixels >= 1) return std::min(pixels, most);
  throw DecodeError(
      fmt::format("{}: expected a number of pixels, got '{}'", kMaxPixelsVariable, text));
}

}  // namespace

void check_size(Index width, Index height, SampleKind kind) {
  if (width < 1 || height < 1) throw DecodeError("it is damaged or has no pixels");
  const bool is_packed = kind == SampleKind::bit;
  const Index most = is_packed ? kMaxPackedPixels : kMaxImagePixels, allowed = allowed_pixels(most);
  if (height <= allowed / width) return;
  if (allowed < most) {
    throw DecodeError(
        fmt::format("it has more pixels than {}={} allows", kMaxPixelsVariable, allowed));
  }
  throw DecodeError(fmt::format("it has more than 2^{} pixels", is_packed ? 40 : 31));
}

Pixels make_pixels(Index width, Index height, int channels, SampleKind kind) {
  check_size(width, height, kind);
  Pixels image = {.width = width, .height = height, .channels = channels, .kind = kind};
  image.bytes = detail::make_uninitialised<std::uint8_t>(
      static_cast<std::size_t>(height * image.row_bytes()));
  return image;
}

void check_claim(Index width, Index height, Index needed, std::size_t size) {
  if (width < 1 || height > kMaxImagePixels / width || needed <= static_cast<Index>(size)) return;
  throw DecodeError(
      fmt::format("it has {} bytes, too few for {} x {} pixels", size, width, height));
}

namespace {

/// From a pixel to its right and to its lower neighbour, in pixels of the source.
struct Steps {
  Index first;
  Index right;
  Index down;
};

/// Which coordinates of the source run backwards.
struct Flips {
  bool x;
  bool y;
};

Flips flips_of(int orientation) {
  return {orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8,
          orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7};
}

Steps steps_of(Index width, Index height, int orientation) {
  const Flips flips = flips_of(orientation);
  const Index along = flips.x ? -1 : 1, across = flips.y ? -width : width;
  const Index first = (flips.x ? width - 1 : 0) + (flips.y ? (height - 1) * width : 0);
  return orientation < 5 ? Steps{first, along, across} : Steps{first, across, along};
}

/// Calls `work` with `size`, which is one of these, as a constant.
template <Index... kSizes, class Work>
void for_size(Index size, const Work& work) {
  static_cast<void>(
      ((size == kSizes && (work(std::integral_constant<Index, kSizes>()), true)) || ...));
}

/// Makes a transform of the source one of the upright image of this size.
void turn_back(std::array<double, 6>& transform, Index width, Index height, int orientation) {
  auto& [a, b, c, d, e, f] = transform;
  const bool transposes = orientation > 4;
  if (transposes) std::swap(width, height);
  const Flips flips = flips_of(orientation);
  if (flips.x) {
    c += a * static_cast<double>(width);
    f += d * static_cast<double>(width);
    a = -a;
    d = -d;
  }
  if (flips.y) {
    c += b * static_cast<double>(height);
    f += e * static_cast<double>(height);
    b = -b;
    e = -e;
  }
  if (!transposes) return;
  std::swap(a, b);
  std::swap(d, e);
}

/// In blocks, as neighbours in one image lie far apart in the other.
template <Index kBytes>
void turn(const Pixels& from, const Pixels& to, const Steps& steps) {
  constexpr Index side = 64;
  for (Index top = 0; top < to.height; top += side) {
    for (Index left = 0; left < to.width; left += side) {
      for (Index y = top; y < std::min(top + side, to.height); ++y) {
        const std::uint8_t* source =
            from.bytes.get() + (steps.first + y * steps.down + left * steps.right) * kBytes;
        std::uint8_t* target = to.bytes.get() + (y * to.width + left) * kBytes;
        for (Index x = left; x < std::min(left + side, to.width); ++x) {
          std::memcpy(target, source, kBytes);
          target += kBytes;
          source += steps.right * kBytes;
        }
      }
    }
  }
}

}  // namespace

Pixels turned(Pixels image, int orientation) {
  if (orientation < 2 || orientation > 8) return image;
  Pixels to = make_pixels(orientation < 5 ? image.width : image.height,
                          orientation < 5 ? image.height : image.width, image.channels, image.kind);
  const Steps steps = steps_of(image.width, image.height, orientation);
  for_size<1, 2, 3, 4, 6, 8, 12, 16, 24, 32>(image.channels * sample_bytes(image.kind),
                                             [&](auto bytes) { turn<bytes()>(image, to, steps); });
  std::swap(image.bytes, to.bytes);
  std::swap(image.width, to.width);
  std::swap(image.height, to.height);
  if (image.place) turn_back(image.place->transform, image.width, image.height, orientation);
  return image;
}

int exif_orientation(std::string_view exif) {
  if (exif.starts_with(std::string_view("Exif\0\0", 6))) exif.remove_prefix(6);
  const bool is_big = exif.starts_with("MM");
  const auto number = [&](std::size_t at, std::size_t count) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < count && at + count <= exif.size(); ++i) {
      value = value << 8 | static_cast<std::uint8_t>(exif[is_big ? at + i : at + count - 1 - i]);
    }
    return value;
  };
  constexpr std::size_t entry_bytes = 12, orientation = 0x112;
  const std::size_t list = number(4, 4), entries = number(list, 2);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t at = list + 2 + i * entry_bytes;
    if (number(at, 2) == orientation) return static_cast<int>(number(at + 8, 2));
  }
  return 0;
}

namespace {

template <Index kChannels, class T>
void look_up(const Pixels& indices, const std::vector<PaletteColour>& palette, const Pixels& to) {
  const T* const from = indices.samples_of_row<T>(0);
  std::uint8_t* target = to.bytes.get();
  for (Index i = 0; i < indices.samples(); ++i, target += kChannels) {
    const PaletteColour& c = palette[from[i]];
    target[0] = c.red;
    if constexpr (kChannels > 2) target[1] = c.green;
    if constexpr (kChannels > 2) target[2] = c.blue;
    if constexpr (kChannels % 2 == 0) target[kChannels - 1] = c.opacity;
  }
}

template <class T>
void look_up(const Pixels& indices, std::vector<PaletteColour> palette, const Pixels& to) {
  palette.resize(std::size_t{std::numeric_limits<T>::max()} + 1, {0, 0, 0, 255});
  for_size<1, 2, 3, 4>(to.channels,
                       [&](auto channels) { look_up<channels(), T>(indices, palette, to); });
}

}  // namespace

Pixels through_palette(const Pixels& indices, const std::vector<PaletteColour>& palette) {
  const bool is_grey = std::ranges::all_of(
      palette, [](const PaletteColour& c) { return c.red == c.green && c.green == c.blue; });
  const bool is_opaque =
      std::ranges::all_of(palette, [](const PaletteColour& c) { return c.opacity == 255; });
  Pixels to = make_pixels(indices.width, indices.height, (is_grey ? 1 : 3) + (is_opaque ? 0 : 1),
                          SampleKind::u8);
  if (indices.kind == SampleKind::u8) {
    look_up<std::uint8_t>(indices, palette, to);
  } else {
    look_up<std::uint16_t>(indices, palette, to);
  }
  to.warning = indices.warning;
  to.place = indices.place;
  return to;
}

}  // namespace thinbench
