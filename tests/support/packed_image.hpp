// Packed images of tests, packed pixel by pixel.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/byte_image.hpp"
#include "thinbench/packed.hpp"

namespace thinbench {

/// `gap` bytes follow each row. They are `filler`.
class PackedImage {
 public:
  PackedImage(Index width, Index height, BitOrder order, Index gap = 0, std::uint8_t filler = 0)
      : width_(width),
        height_(height),
        stride_(packed_row_bytes(width) + gap),
        order_(order),
        bytes_(static_cast<std::size_t>(stride_ * height), filler) {}

  /// Packs an image. Unused bits of rows are 1 with a filler of 0xFF, else 0.
  PackedImage(const ConstImageView& image, BitOrder order, Index gap = 0, std::uint8_t filler = 0)
      : PackedImage(image.width, image.height, order, gap, filler) {
    for (Index y = 0; y < height_; ++y) {
      for (Index x = 0; x < packed_row_bytes(width_) * 8; ++x) {
        set(x, y, x < width_ ? image.row(y)[x] != 0 : filler == 0xFF);
      }
    }
  }

  [[nodiscard]] PackedView view() { return {bytes_.data(), width_, height_, stride_, order_}; }
  [[nodiscard]] ConstPackedView view() const {
    return {bytes_.data(), width_, height_, stride_, order_};
  }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

  friend bool operator==(const PackedImage&, const PackedImage&) = default;

 private:
  void set(Index x, Index y, bool foreground) {
    std::uint8_t& byte = bytes_[static_cast<std::size_t>(y * stride_ + x / 8)];
    const int bit =
        order_ == BitOrder::msb_first ? 7 - static_cast<int>(x % 8) : static_cast<int>(x % 8);
    byte = static_cast<std::uint8_t>(foreground ? byte | 1 << bit : byte & ~(1 << bit));
  }

  Index width_;
  Index height_;
  Index stride_;
  BitOrder order_;
  std::vector<std::uint8_t> bytes_;
};

inline std::string raw_bytes(const PackedImage& image) {
  return {image.bytes().begin(), image.bytes().end()};
}

}  // namespace thinbench
