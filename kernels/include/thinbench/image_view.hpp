// Views of images and of stacks of images: an address, a size and strides. Views neither own memory
// nor check anything; functions that take views check them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace thinbench {

/// Sizes, coordinates and strides. Signed, so that `y - 1` is safe to write.
using Index = std::int64_t;

/// An image: pixel (x, y) is `data[y * stride + x]`; y points down. `stride` is the distance
/// between rows in pixels. It may exceed the width, so a view can show part of a larger image. A
/// writable view converts to a read-only one.
template <class T>
struct View {
  T* data = nullptr;
  Index width = 0;
  Index height = 0;
  Index stride = 0;

  constexpr View() = default;
  /// Contiguous rows.
  constexpr View(T* pixels, Index columns, Index rows) : View(pixels, columns, rows, columns) {}
  constexpr View(T* pixels, Index columns, Index rows, Index row_pixels)
      : data(pixels), width(columns), height(rows), stride(row_pixels) {}

  [[nodiscard]] constexpr T* row(Index y) const { return data + y * stride; }
  constexpr operator View<const T>() const requires(!std::is_const_v<T>) {
    return {data, width, height, stride};
  }
};

/// One byte per pixel. Binary images: 0 is background, anything else is foreground; results are 0
/// and 255. Grey images: 0 is black.
using ConstImageView = View<const std::uint8_t>;
using ImageView = View<std::uint8_t>;

/// Labels of 32 bits; the stride is in labels, not in bytes.
using ConstLabelView = View<const std::int32_t>;
using LabelView = View<std::int32_t>;

/// A stack of images of one size: pixel (x, y) of image i is
/// `data[i * image_stride + y * stride + x]`. Strides are in pixels. There may be gaps between rows
/// and between images; images share no byte.
template <class T>
struct Stack {
  T* data = nullptr;
  Index count = 0;
  Index width = 0;
  Index height = 0;
  Index stride = 0;
  Index image_stride = 0;

  constexpr Stack() = default;
  /// Contiguous, as a NumPy array of shape (images, rows, columns).
  constexpr Stack(T* pixels, Index images, Index columns, Index rows)
      : Stack(pixels, images, columns, rows, columns, columns * rows) {}
  constexpr Stack(T* pixels, Index images, Index columns, Index rows, Index row_pixels,
                  Index image_pixels)
      : data(pixels),
        count(images),
        width(columns),
        height(rows),
        stride(row_pixels),
        image_stride(image_pixels) {}

  [[nodiscard]] constexpr View<T> image(Index i) const {
    return {data + i * image_stride, width, height, stride};
  }
  constexpr operator Stack<const T>() const requires(!std::is_const_v<T>) {
    return {data, count, width, height, stride, image_stride};
  }
};

using ConstStackView = Stack<const std::uint8_t>;
using StackView = Stack<std::uint8_t>;

}  // namespace thinbench
