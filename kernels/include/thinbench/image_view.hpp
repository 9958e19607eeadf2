// Views of images and of stacks of images: an address, a size and strides. Views neither own memory
// nor check anything; functions that take views check them.
#pragma once

#include <cstddef>
#include <cstdint>

namespace thinbench {

/// Sizes, coordinates and strides. Signed, so that `y - 1` is safe to write.
using Index = std::ptrdiff_t;

/// Read-only image, one byte per pixel: pixel (x, y) is `data[y * stride + x]`; y points down.
///
/// Binary images: 0 is background, anything else is foreground. Grey images: 0 is black. `stride`
/// is the distance between rows in bytes. It may exceed the width, so a view can show part of a
/// larger image.
struct ConstImageView {
  const std::uint8_t* data = nullptr;
  Index width = 0;
  Index height = 0;
  Index stride = 0;

  constexpr ConstImageView() = default;
  /// Contiguous rows.
  constexpr ConstImageView(const std::uint8_t* pixels, Index columns, Index rows)
      : ConstImageView(pixels, columns, rows, columns) {}
  constexpr ConstImageView(const std::uint8_t* pixels, Index columns, Index rows, Index row_bytes)
      : data(pixels), width(columns), height(rows), stride(row_bytes) {}

  [[nodiscard]] constexpr const std::uint8_t* row(Index y) const { return data + y * stride; }
};

/// Writable image; see ConstImageView. Binary results are 0 and 255.
struct ImageView {
  std::uint8_t* data = nullptr;
  Index width = 0;
  Index height = 0;
  Index stride = 0;

  constexpr ImageView() = default;
  constexpr ImageView(std::uint8_t* pixels, Index columns, Index rows)
      : ImageView(pixels, columns, rows, columns) {}
  constexpr ImageView(std::uint8_t* pixels, Index columns, Index rows, Index row_bytes)
      : data(pixels), width(columns), height(rows), stride(row_bytes) {}

  [[nodiscard]] constexpr std::uint8_t* row(Index y) const { return data + y * stride; }
  constexpr operator ConstImageView() const { return {data, width, height, stride}; }
};

/// Read-only image of 32-bit labels: pixel (x, y) is `data[y * stride + x]`; the stride is in labels,
/// not in bytes.
struct ConstLabelView {
  const std::int32_t* data = nullptr;
  Index width = 0;
  Index height = 0;
  Index stride = 0;

  constexpr ConstLabelView() = default;
  constexpr ConstLabelView(const std::int32_t* labels, Index columns, Index rows)
      : ConstLabelView(labels, columns, rows, columns) {}
  constexpr ConstLabelView(const std::int32_t* labels, Index columns, Index rows, Index row_labels)
      : data(labels), width(columns), height(rows), stride(row_labels) {}

  [[nodiscard]] constexpr const std::int32_t* row(Index y) const { return data + y * stride; }
};

/// Writable image of labels; see ConstLabelView.
struct LabelView {
  std::int32_t* data = nullptr;
  Index width = 0;
  Index height = 0;
  Index stride = 0;

  constexpr LabelView() = default;
  constexpr LabelView(std::int32_t* labels, Index columns, Index rows)
      : LabelView(labels, columns, rows, columns) {}
  constexpr LabelView(std::int32_t* labels, Index columns, Index rows, Index row_labels)
      : data(labels), width(columns), height(rows), stride(row_labels) {}

  [[nodiscard]] constexpr std::int32_t* row(Index y) const { return data + y * stride; }
  constexpr operator ConstLabelView() const { return {data, width, height, stride}; }
};

/// Read-only stack of images of one size: pixel (x, y) of image i is
/// `data[i * image_stride + y * stride + x]`. Strides are in bytes. There may be gaps between rows
/// and between images; images share no byte.
struct ConstStackView {
  const std::uint8_t* data = nullptr;
  Index count = 0;
  Index width = 0;
  Index height = 0;
  Index stride = 0;
  Index image_stride = 0;

  constexpr ConstStackView() = default;
  /// Contiguous, as a NumPy array of shape (images, rows, columns).
  constexpr ConstStackView(const std::uint8_t* pixels, Index images, Index columns, Index rows)
      : ConstStackView(pixels, images, columns, rows, columns, columns * rows) {}
  constexpr ConstStackView(const std::uint8_t* pixels, Index images, Index columns, Index rows,
                           Index row_bytes, Index image_bytes)
      : data(pixels),
        count(images),
        width(columns),
        height(rows),
        stride(row_bytes),
        image_stride(image_bytes) {}

  [[nodiscard]] constexpr ConstImageView image(Index i) const {
    return {data + i * image_stride, width, height, stride};
  }
};

/// Writable stack; see ConstStackView.
struct StackView {
  std::uint8_t* data = nullptr;
  Index count = 0;
  Index width = 0;
  Index height = 0;
  Index stride = 0;
  Index image_stride = 0;

  constexpr StackView() = default;
  constexpr StackView(std::uint8_t* pixels, Index images, Index columns, Index rows)
      : StackView(pixels, images, columns, rows, columns, columns * rows) {}
  constexpr StackView(std::uint8_t* pixels, Index images, Index columns, Index rows,
                      Index row_bytes, Index image_bytes)
      : data(pixels),
        count(images),
        width(columns),
        height(rows),
        stride(row_bytes),
        image_stride(image_bytes) {}

  [[nodiscard]] constexpr ImageView image(Index i) const {
    return {data + i * image_stride, width, height, stride};
  }
  constexpr operator ConstStackView() const {
    return {data, count, width, height, stride, image_stride};
  }
};

}  // namespace thinbench
