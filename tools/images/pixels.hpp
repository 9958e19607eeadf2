// Decoded images: samples as their file has them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "support/byte_image.hpp"
#include "thinbench/packed.hpp"

namespace thinbench {

/// The largest image that is read, in pixels; of packed ones 2^40.
inline constexpr Index kMaxImagePixels = Index{1} << 31;
/// In the environment, a lower limit.
inline constexpr const char* kMaxPixelsVariable = "THINBENCH_MAX_PIXELS";

enum class SampleKind : std::uint8_t {
  bit,  // eight in a byte, the first in its highest bit
  u8,
  u16,
  i8,  // from here on numbers, not levels
  i16,
  u32,
  i32,
  f32,
  f64
};

/// Calls `work` with a sample of the type that a kind other than `bit` has.
template <class Work>
auto for_type(SampleKind kind, const Work& work) {
  switch (kind) {
    case SampleKind::u16:
      return work(std::uint16_t{});
    case SampleKind::i8:
      return work(std::int8_t{});
    case SampleKind::i16:
      return work(std::int16_t{});
    case SampleKind::u32:
      return work(std::uint32_t{});
    case SampleKind::i32:
      return work(std::int32_t{});
    case SampleKind::f32:
      return work(float{});
    case SampleKind::f64:
      return work(double{});
    default:
      return work(std::uint8_t{});
  }
}

[[nodiscard]] inline Index sample_bytes(SampleKind kind) {
  return for_type(kind, [](auto sample) { return Index{sizeof(sample)}; });
}

/// Where the pixels of a map lie: x' = a x + b y + c, y' = d x + e y + f from the corner of the
/// first pixel, and the number of the coordinate system, 0 if unknown.
struct GeoReference {
  std::array<double, 6> transform = {};
  int epsg = 0;
};

/// Rows without gaps.
struct Pixels {
  Index width = 0;
  Index height = 0;
  int channels = 1;  // 1: grey, 3: red, green, blue; 2 and 4: and opacity
  SampleKind kind = SampleKind::u8;
  detail::AlignedArray<std::uint8_t> bytes = nullptr;
  std::uint32_t highest = 0;      // what samples reach, such as 4095; 0: what their kind holds
  bool is_premultiplied = false;  // colours are multiplied by the opacity
  bool shows_black = false;       // where transparent, unless the user wants otherwise
  std::optional<double> nodata = std::nullopt;  // the number that stands for none
  std::string warning = {};                     // of the decoder
  std::optional<GeoReference> place = std::nullopt;

  [[nodiscard]] bool has_opacity() const { return channels % 2 == 0; }
  [[nodiscard]] Index samples() const { return width * height * channels; }
  [[nodiscard]] Index row_bytes() const {
    return kind == SampleKind::bit ? packed_row_bytes(width)
                                   : width * channels * sample_bytes(kind);
  }
  [[nodiscard]] std::uint8_t* row(Index y) const { return bytes.get() + y * row_bytes(); }
  template <class T>
  [[nodiscard]] T* samples_of_row(Index y) const {
    return reinterpret_cast<T*>(row(y));
  }
};

/// Why bytes are no image, without the name of the file.
struct DecodeError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws DecodeError for a size without pixels or of too many.
void check_size(Index width, Index height, SampleKind kind);

/// With any samples. Throws as check_size(), and std::bad_alloc.
[[nodiscard]] Pixels make_pixels(Index width, Index height, int channels, SampleKind kind);

/// Throws DecodeError where a file of `size` bytes is too short for `needed`: files of a few bytes
/// may claim gigabytes, so this comes before memory is taken.
void check_claim(Index width, Index height, Index needed, std::size_t size);

/// The bytes of rows that are padded to whole bytes; the largest number where it is larger.
[[nodiscard]] Index bytes_of_rows(Index width, Index height, Index bits_per_pixel);

/// Upright: `orientation` as in EXIF and TIFF, 1 to 8; others change nothing.
[[nodiscard]] Pixels turned(Pixels image, int orientation);

/// Of EXIF data, a TIFF file without images; 0 if there is none.
[[nodiscard]] int exif_orientation(std::string_view exif);

struct PaletteColour {
  std::uint8_t red, green, blue, opacity;
};

/// What indices of 8 or 16 bits stand for: grey where all colours are, with opacity where one has
/// it. An index past the end is black.
[[nodiscard]] Pixels through_palette(const Pixels& indices,
                                     const std::vector<PaletteColour>& palette);

}  // namespace thinbench
