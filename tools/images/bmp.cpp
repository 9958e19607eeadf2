#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "images/codecs.hpp"

namespace thinbench {
namespace {

constexpr std::size_t kFileHeader = 14;

// What the header says of compression.
constexpr std::uint32_t kPlain = 0, kRuns8 = 1, kRuns4 = 2, kMasks = 3, kJpeg = 4, kPng = 5,
                        kMasksWithOpacity = 6;

/// A channel of pixels of 16 or 32 bits.
class Mask {
 public:
  Mask() = default;
  explicit Mask(std::uint32_t mask)
      : mask_(mask), shift_(mask == 0 ? 0 : std::countr_zero(mask)), max_(mask >> shift_) {}

  [[nodiscard]] bool is_empty() const { return mask_ == 0; }
  [[nodiscard]] bool is_byte() const { return max_ == 255 && shift_ % 8 == 0; }
  [[nodiscard]] int byte() const { return shift_ / 8; }
  /// From 0 to 255, rounded.
  [[nodiscard]] std::uint8_t level(std::uint32_t pixel) const {
    const std::uint64_t value = (pixel & mask_) >> shift_, max = max_;
    return max_ == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>((value * 255 + max / 2) / max);
  }

 private:
  std::uint32_t mask_ = 0;
  int shift_ = 0;
  std::uint32_t max_ = 0;
};

class BmpReader {
 public:
  explicit BmpReader(std::string_view bytes) : bytes_(bytes) {
    const bool is_os2 = number(14, 4) == 12;
    width_ = is_os2 ? Index{number(18, 2)} : Index{static_cast<std::int32_t>(number(18, 4))};
    const Index height =
        is_os2 ? Index{number(20, 2)} : Index{static_cast<std::int32_t>(number(22, 4))};
    height_ = height < 0 ? -height : height;
    is_top_down_ = height < 0;
    bits_ = number(is_os2 ? 24 : 28, 2);
    compression_ = is_os2 ? kPlain : number(30, 4);
    header_ = number(14, 4);
    data_ = number(10, 4);
    read_palette(is_os2 ? 3 : 4);
    read_masks();
  }

  Pixels decode(bool as_stored) {
    check();
    if (bits_ > 8) return without_empty_opacity(by_masks());
    Pixels indices = make_pixels(width_, height_, 1, SampleKind::u8);
    has_runs() ? read_runs(indices) : read_indices(indices);
    if (has_grey_levels()) return indices;
    Pixels levels = through_palette(indices, palette_);
    return as_stored && levels.channels > 1 ? std::move(indices) : std::move(levels);
  }

 private:
  [[nodiscard]] std::uint32_t number(std::size_t at, std::size_t count) const {
    return little_endian(bytes_, at, count);
  }
  /// Whether every index is its level.
  [[nodiscard]] bool has_grey_levels() const {
    if (palette_.size() != 256) return false;
    for (std::size_t i = 0; i < palette_.size(); ++i) {
      const PaletteColour& colour = palette_[i];
      if (colour.red != i || colour.green != i || colour.blue != i) return false;
    }
    return true;
  }
  [[nodiscard]] bool has_runs() const { return compression_ == kRuns8 || compression_ == kRuns4; }
  [[nodiscard]] Index row_bytes() const { return (width_ * bits_ + 31) / 32 * 4; }

  void check() const {
    if (compression_ == kJpeg || compression_ == kPng) {
      throw DecodeError("it is a BMP file that holds a JPEG or PNG file, which is not read");
    }
    constexpr std::array known = {1U, 2U, 4U, 8U, 16U, 24U, 32U};
    const bool fits = !has_runs() || bits_ == (compression_ == kRuns8 ? 8 : 4);
    if (std::ranges::find(known, bits_) == known.end() || compression_ > kMasksWithOpacity ||
        !fits) {
      throw DecodeError(
          fmt::format("it is a BMP file of {} bits with compression {}, which is not read", bits_,
                      compression_));
    }
    if (width_ < 1 || height_ < 1 || data_ > bytes_.size())
      throw DecodeError("it is damaged or has no pixels");
    if (has_runs()) return;
    // The last row of some writers ends with its last pixel.
    const Index last = (width_ * bits_ + 7) / 8;
    const auto header_bytes = static_cast<Index>(data_);
    check_claim(width_, height_, header_bytes + row_bytes() * (height_ - 1) + last, bytes_.size());
  }

  void read_palette(std::size_t entry) {
    if (bits_ > 8) return;
    const std::size_t start = kFileHeader + header_, used = entry == 4 ? number(46, 4) : 0;
    const std::size_t all = std::size_t{1} << bits_;
    const std::size_t count = used == 0 || used > all ? all : used;
    for (std::size_t i = 0; i < count && start + (i + 1) * entry <= bytes_.size(); ++i) {
      const auto at = [&](std::size_t k) {
        return static_cast<std::uint8_t>(bytes_[start + i * entry + k]);
      };
      palette_.push_back({at(2), at(1), at(0), 255});
    }
  }

  /// In the header of 52 bytes and more, or behind that of 40.
  void read_masks() {
    std::array<std::uint32_t, 4> masks = {0xFF0000, 0xFF00, 0xFF, 0};
    if (bits_ == 16) masks = {0x7C00, 0x3E0, 0x1F, 0};
    if (compression_ == kMasks || compression_ == kMasksWithOpacity) {
      const bool has_opacity = header_ >= 56 || compression_ == kMasksWithOpacity;
      for (std::size_t i = 0; i < 4; ++i)
        masks[i] = i < 3 || has_opacity ? number(54 + 4 * i, 4) : 0;
    }
    const std::uint32_t pixel = bits_ < 32 ? (1U << bits_) - 1 : ~0U;
    for (std::size_t i = 0; i < 4; ++i) masks_[i] = Mask(masks[i] & pixel);
  }

  /// As rows lie in the file.
  [[nodiscard]] std::uint8_t* row_of(const Pixels& image, Index y) const {
    return image.row(is_top_down_ ? y : height_ - 1 - y);
  }

  void read_indices(const Pixels& image) const {
    for (Index y = 0; y < height_; ++y) {
      const auto* const from =
          reinterpret_cast<const std::uint8_t*>(bytes_.data() + data_ + y * row_bytes());
      std::uint8_t* const to = row_of(image, y);
      if (bits_ == 8) {
        std::copy_n(from, width_, to);
        continue;
      }
      const Index in_byte = 8 / bits_;
      for (Index x = 0; x < width_; ++x) {
        const Index shift = 8 - bits_ * (x % in_byte + 1);
        to[x] = static_cast<std::uint8_t>(from[x / in_byte] >> shift & ((1 << bits_) - 1));
      }
    }
  }

  [[nodiscard]] Pixels by_masks() const {
    const std::span masks(masks_.data(), masks_[3].is_empty() ? 3U : 4U);
    Pixels image = make_pixels(width_, height_, static_cast<int>(masks.size()), SampleKind::u8);
    const bool has_bytes = std::ranges::all_of(masks, &Mask::is_byte);
    for (Index y = 0; y < height_; ++y) {
      const char* const from = bytes_.data() + data_ + y * row_bytes();
      has_bytes ? copy_bytes(from, masks, row_of(image, y)) : scale(from, masks, row_of(image, y));
    }
    return image;
  }

  void copy_bytes(const char* from, std::span<const Mask> masks, std::uint8_t* to) const {
    std::array<int, 4> at{};
    std::ranges::transform(masks, at.begin(), &Mask::byte);
    const bool is_short = bits_ == 24;
    if (masks.size() == 3) {
      is_short ? copy_bytes<3, 3>(from, at, to) : copy_bytes<4, 3>(from, at, to);
    } else {
      is_short ? copy_bytes<3, 4>(from, at, to) : copy_bytes<4, 4>(from, at, to);
    }
  }

  template <int kFrom, std::size_t kTo>
  void copy_bytes(const char* from, std::array<int, 4> at, std::uint8_t* to) const {
    for (Index x = 0; x < width_; ++x, from += kFrom, to += kTo) {
      for (std::size_t k = 0; k < kTo; ++k) to[k] = static_cast<std::uint8_t>(from[at[k]]);
    }
  }

  void scale(const char* from, std::span<const Mask> masks, std::uint8_t* to) const {
    for (Index x = 0; x < width_; ++x, from += bits_ / 8) {
      const std::uint32_t pixel = little_endian({from, bits_ / 8}, 0, bits_ / 8);
      for (const Mask& mask : masks) *to++ = mask.level(pixel);
    }
  }

  /// Writers that know no opacity leave it at 0 everywhere.
  [[nodiscard]] static Pixels without_empty_opacity(Pixels image) {
    if (!image.has_opacity()) return image;
    std::uint8_t* const all = image.bytes.get();
    const Index end = image.samples();
    for (Index i = 3; i < end; i += 4) {
      if (all[i] != 0) return image;
    }
    for (Index i = 3; i < end; i += 4) all[i] = 255;
    return image;
  }

  /// Pixels that runs skip are of the first colour; those beyond a row's end are ignored, as some
  /// writers pad rows.
  void read_runs(const Pixels& image) const {
    std::fill_n(image.bytes.get(), image.samples(), std::uint8_t{0});
    std::size_t at = data_;
    Index x = 0, y = 0;
    const auto next = [&]() -> std::uint8_t {
      if (at >= bytes_.size()) throw DecodeError("the file is truncated");
      return static_cast<std::uint8_t>(bytes_[at++]);
    };
    const auto put = [&](int index) {
      if (x < width_ && y < height_) row_of(image, y)[x] = static_cast<std::uint8_t>(index);
      ++x;
    };
    const auto put_byte_part = [&](std::uint8_t byte, int i) {
      put(bits_ == 8 ? byte : i % 2 == 0 ? byte >> 4 : byte & 15);
    };
    while (y < height_ || at < bytes_.size()) {
      const std::uint8_t count = next(), code = next();
      if (count > 0) {
        for (int i = 0; i < count; ++i) put_byte_part(code, i);
      } else if (code == 0) {  // the end of a row
        x = 0;
        ++y;
      } else if (code == 1) {  // of the image
        return;
      } else if (code == 2) {  // a step
        x += next();
        y += next();
      } else {  // single pixels, in an even number of bytes
        const std::size_t start = at;
        std::uint8_t byte = 0;
        for (int i = 0; i < code; ++i) {
          if (bits_ == 8 || i % 2 == 0) byte = next();
          put_byte_part(byte, i);
        }
        if ((at - start) % 2 != 0) static_cast<void>(next());
      }
    }
  }

  std::string_view bytes_;
  Index width_ = 0;
  Index height_ = 0;
  bool is_top_down_ = false;
  std::uint32_t bits_ = 0;
  std::uint32_t compression_ = 0;
  std::size_t header_ = 0;  // its bytes
  std::size_t data_ = 0;    // where pixels begin
  std::vector<PaletteColour> palette_;
  std::array<Mask, 4> masks_;
};

void add(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> 8 * i & 0xFF);
}

}  // namespace

Pixels decode_bmp(std::string_view bytes, const Decoding& request) {
  return BmpReader(bytes).decode(request.as_stored);
}

std::string encode_bmp(const Samples& image) {
  const std::uint32_t colours = image.channels == 1 ? 256 : 0;
  const Index row_bytes = (image.row_bytes() + 3) / 4 * 4;
  const auto start = static_cast<std::uint32_t>(kFileHeader + 40 + 4 * colours);
  const auto pixels = static_cast<std::uint32_t>(row_bytes * image.height);
  std::string bytes = "BM";
  bytes.reserve(start + std::size_t{pixels});
  for (const std::uint32_t value :
       {start + pixels, 0U, start, 40U, static_cast<std::uint32_t>(image.width),
        static_cast<std::uint32_t>(image.height)}) {
    add(bytes, value, 4);
  }
  add(bytes, 1, 2);
  add(bytes, image.channels == 1 ? 8 : 24, 2);
  for (const std::uint32_t value : {0U, pixels, 0U, 0U, colours, 0U}) add(bytes, value, 4);
  for (std::uint32_t i = 0; i < colours; ++i) add(bytes, i * 0x10101, 4);
  for (Index y = image.height; y-- > 0;) {
    const std::size_t row = bytes.size();
    bytes.append(reinterpret_cast<const char*>(image.row(y)),
                 static_cast<std::size_t>(image.row_bytes()));
    for (std::size_t i = row; image.channels == 3 && i < bytes.size(); i += 3)
      std::swap(bytes[i], bytes[i + 2]);
    bytes.resize(row + static_cast<std::size_t>(row_bytes));
  }
  return bytes;
}

}  // namespace thinbench
