#include "images/geo_tiff.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <string_view>

namespace thinbench {
namespace {

constexpr std::uint32_t kPixelScale = 33550, kTiePoint = 33922, kTransformation = 34264,
                        kKeys = 34735, kNodata = 42113;

/// The values of a tag that libtiff does not know; empty if it is not there.
template <class T>
std::span<const T> values_of(const TiffHandle& tiff, std::uint32_t tag) {
  std::uint32_t count = 0;
  const T* values = nullptr;
  const TIFFField* const field = TIFFFindField(tiff.get(), tag, TIFF_ANY);
  const TIFFDataType type = sizeof(T) == 8 ? TIFF_DOUBLE : sizeof(T) == 2 ? TIFF_SHORT : TIFF_ASCII;
  if (field == nullptr || TIFFFieldDataType(field) != type) return {};
  return TIFFGetField(tiff.get(), tag, &count, &values) == 1 ? std::span(values, count)
                                                             : std::span<const T>();
}

/// The value of a GeoKey that is one number; 0 if it is not there.
int key(std::span<const std::uint16_t> keys, int wanted) {
  for (std::size_t i = 4; i + 4 <= keys.size(); i += 4) {
    if (keys[i] == wanted && keys[i + 1] == 0) return keys[i + 3];
  }
  return 0;
}

}  // namespace

std::optional<GeoReference> geo_reference_of(const TiffHandle& tiff) {
  constexpr int model_type = 1024, model_geographic = 2, raster_type = 1025, geographic = 2048,
                projected = 3072;
  constexpr int pixel_is_point = 2, user_defined = 32767;
  const auto scale = values_of<double>(tiff, kPixelScale), tie = values_of<double>(tiff, kTiePoint);
  const auto matrix = values_of<double>(tiff, kTransformation);
  const auto keys = values_of<std::uint16_t>(tiff, kKeys);
  GeoReference place;
  if (matrix.size() == 16) {
    place.transform = {matrix[0], matrix[1], matrix[3], matrix[4], matrix[5], matrix[7]};
  } else if (scale.size() >= 2 && tie.size() >= 6) {
    place.transform = {scale[0], 0,         tie[3] - tie[0] * scale[0],
                       0,        -scale[1], tie[4] + tie[1] * scale[1]};
  } else {
    return std::nullopt;
  }
  auto& [a, b, c, d, e, f] = place.transform;
  if (key(keys, raster_type) == pixel_is_point) {  // coordinates are those of centres
    c -= (a + b) / 2;
    f -= (d + e) / 2;
  }
  const auto is_finite = [](double v) { return std::isfinite(v); };
  if (!std::ranges::all_of(place.transform, is_finite)) return std::nullopt;
  const int model = key(keys, model_type);
  const bool is_geographic = model == model_geographic || (model == 0 && key(keys, projected) == 0);
  if (model <= model_geographic) place.epsg = key(keys, is_geographic ? geographic : projected);
  if (place.epsg == user_defined) place.epsg = 0;
  return place;
}

std::optional<double> nodata_of(const TiffHandle& tiff) {
  const std::span<const char> value = values_of<char>(tiff, kNodata);
  constexpr std::string_view blank(" \t\n\r\0", 5);
  std::string_view text(value.data(), value.size());
  text.remove_prefix(std::min(text.find_first_not_of(blank), text.size()));
  text = text.substr(0, text.find_last_not_of(blank) + 1);
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return is_number ? std::optional(number) : std::nullopt;
}

}  // namespace thinbench
