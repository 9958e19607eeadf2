// Byte images in aligned memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>

#include "core/memory_pool.hpp"
#include "core/plane_view.hpp"

namespace thinbench::detail {

struct AlignedDelete {
  void operator()(void* memory) const noexcept { give_block(memory); }
};

template <class T>
using AlignedArray = std::unique_ptr<T[], AlignedDelete>;

/// `count` elements of a type that needs no construction, aligned to a cache line, with any
/// contents. Throws std::bad_alloc.
template <class T>
[[nodiscard]] AlignedArray<T> make_uninitialised(std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (count > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_alloc();
  return AlignedArray<T>(static_cast<T*>(take_block(count * sizeof(T))));
}

/// The same, zeroed.
template <class T>
[[nodiscard]] AlignedArray<T> make_aligned(std::size_t count) {
  AlignedArray<T> array = make_uninitialised<T>(count);
  std::fill_n(array.get(), count, T{});
  return array;
}

/// Owns an image.
class ByteImage {
 public:
  ByteImage() = default;
  /// Zero everywhere. The stride is padded_row_bytes(width).
  ByteImage(Index width, Index height);
  /// Pixels that exist already, until `release` ends.
  ByteImage(const ImageView& pixels, std::function<void(void*)> release);

  [[nodiscard]] Index width() const { return width_; }
  [[nodiscard]] Index height() const { return height_; }
  [[nodiscard]] ImageView view() { return {data_.get(), width_, height_, stride_}; }
  [[nodiscard]] ConstImageView view() const { return {data_.get(), width_, height_, stride_}; }
  [[nodiscard]] std::uint8_t& at(Index x, Index y) { return data_[offset(x, y)]; }
  [[nodiscard]] std::uint8_t at(Index x, Index y) const { return data_[offset(x, y)]; }

 private:
  [[nodiscard]] std::size_t offset(Index x, Index y) const {
    return static_cast<std::size_t>(y * stride_ + x);
  }

  Index width_ = 0;
  Index height_ = 0;
  Index stride_ = 0;
  std::unique_ptr<std::uint8_t[], std::function<void(void*)>> data_;
};

[[nodiscard]] ByteImage copy_of(ConstImageView source);

/// Whether sizes and pixels are equal; strides do not matter.
[[nodiscard]] bool equal(ConstImageView a, ConstImageView b);

}  // namespace thinbench::detail
