// Images whose size, place in memory and pixels are drawn from the input of a fuzz target.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include "byte_source.hpp"
#include "harness/test_images.hpp"
#include "support/made_image.hpp"

namespace thinbench {

struct DrawnSize {
  Index width;
  Index height;
};

/// Multiplies all sizes that are drawn.
inline Index size_factor = 1;

/// Mostly small; sometimes as wide as a word or a register and a few pixels more or less, or tall.
inline DrawnSize draw_small_size(ByteSource& input) {
  constexpr Index max_pixels = 4096;
  constexpr std::array<Index, 9> widths = {16, 32, 64, 128, 192, 256, 320, 512, 576};
  const Index kind = input.number(0, 7);
  if (kind == 6) {
    const Index width = input.pick(widths) + input.number(-2, 2);
    return {width, input.number(0, std::max<Index>(4, max_pixels / width / 2))};
  }
  if (kind == 7) return {input.number(0, 40), input.number(0, 100)};
  return {input.number(0, 24), input.number(0, 24)};
}

inline DrawnSize draw_size(ByteSource& input) {
  const auto [width, height] = draw_small_size(input);
  return {width * size_factor, height * size_factor};
}

/// An image in memory of its own, which begins anywhere and ends with its last pixel, so that the
/// address sanitizer sees what is read beside it.
class DrawnImage {
 public:
  DrawnImage(ByteSource& input, const DrawnSize& size)
      : width_(size.width),
        height_(size.height),
        stride_(width_ + (input.once_in(2) ? input.number(1, 70) : 0)),
        offset_(input.once_in(2) ? input.number(1, 63) : 0),
        bytes_(size_of(*this)),
        data_(new std::uint8_t[bytes_]) {
    std::fill_n(data_.get(), bytes_, kGuard);
  }

  [[nodiscard]] ImageView view() { return {data_.get() + offset_, width_, height_, stride_}; }
  [[nodiscard]] ConstImageView view() const {
    return {data_.get() + offset_, width_, height_, stride_};
  }

  void copy_from(const ConstImageView& image) {
    for (Index y = 0; y < height_; ++y) std::copy_n(image.row(y), width_, view().row(y));
  }

  /// Every byte outside the image must be as it was.
  void must_be_intact() const {
    const auto is_guard = [](std::uint8_t byte) { return byte == kGuard; };
    must(std::all_of(data_.get(), data_.get() + offset_, is_guard), "bytes before were changed");
    for (Index y = 0; width_ > 0 && y + 1 < height_; ++y) {
      const std::uint8_t* row = view().row(y);
      must(std::all_of(row + width_, row + stride_, is_guard), "bytes of a gap were changed");
    }
  }

 private:
  static constexpr std::uint8_t kGuard = 0xA5;

  static std::size_t size_of(const DrawnImage& image) {
    const bool has_pixels = image.width_ > 0 && image.height_ > 0;
    const Index last = has_pixels ? (image.height_ - 1) * image.stride_ + image.width_ : 0;
    return static_cast<std::size_t>(image.offset_ + last);
  }

  Index width_;
  Index height_;
  Index stride_;
  Index offset_;
  std::size_t bytes_;
  std::unique_ptr<std::uint8_t[]> data_;
};

/// A copy of an image, and room for a result, which now and then is the place of the copy.
struct DrawnPair {
  DrawnPair(ByteSource& input, const ConstImageView& image, bool works_in_place = true)
      : source(input, {image.width, image.height}),
        destination(input, {image.width, image.height}),
        in_place(works_in_place && input.once_in(4)) {
    source.copy_from(image);
  }

  [[nodiscard]] ImageView to() { return in_place ? source.view() : destination.view(); }

  void must_be_intact() const {
    source.must_be_intact();
    destination.must_be_intact();
  }

  DrawnImage source;
  DrawnImage destination;
  bool in_place;
};

/// Foreground is 255, 1 or anything else that is not 0. Binary pixels are bits of the input, over
/// and over again, or noise.
inline ByteImage draw_binary(ByteSource& input, const DrawnSize& size) {
  const Index width = size.width;
  const Index height = size.height;
  const Index kind = input.number(0, 3);
  const auto foreground = static_cast<std::uint8_t>(input.once_in(4) ? input.number(1, 255) : 255);
  ByteImage image(width, height);
  if (kind == 3) {
    const int percent = static_cast<int>(input.number(0, 100));
    const Index granularity = input.number(1, 9);
    image = noise_image(width, height, percent, granularity, input.byte());
  } else {
    const auto bits = input.take(static_cast<std::size_t>((width * height + 7) / 8));
    if (bits.empty()) return image;
    image = image_by(width, height, [&](Index x, Index y) {
      const std::size_t at = static_cast<std::size_t>(y * width + x) % (8 * bits.size());
      return (bits[at / 8] >> at % 8 & 1) != 0 ? 255 : 0;
    });
  }
  return mapped(image, [=](int pixel) { return pixel & foreground; });
}

/// All levels, from the input over and over again, or noise.
inline ByteImage draw_grey(ByteSource& input, const DrawnSize& size) {
  const Index width = size.width;
  const Index height = size.height;
  if (input.once_in(2)) {
    const std::uint8_t low = input.byte();
    const std::uint8_t high = input.byte();
    return grey_noise_image(width, height, std::min(low, high), std::max(low, high), input.byte());
  }
  const auto levels = input.take(static_cast<std::size_t>(width * height));
  if (levels.empty()) return ByteImage(width, height);
  return image_by(width, height, [&](Index x, Index y) {
    return levels[static_cast<std::size_t>(y * width + x) % levels.size()];
  });
}

/// Both must have the same pixels.
inline void must_be_equal(const ConstImageView& found, const ConstImageView& expected,
                          const std::string& name) {
  must(equal(found, expected), name + " differs from the reference at " +
                                   std::to_string(found.width) + " x " +
                                   std::to_string(found.height));
}

}  // namespace thinbench
