// Thinning of packed binary images: 8 pixels per byte, as in PBM files and numpy.packbits.
#pragma once

#include <cstdint>
#include <type_traits>

#include "thinbench/export.h"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {

/// Which bit of a byte is its first pixel, the one in the west.
enum class BitOrder : std::uint8_t {
  msb_first,  // the highest bit: PBM (P4), TIFF's usual order, NumPy's "big"
  lsb_first,  // the lowest bit: XBM, NumPy's "little"
};

/// The bytes of a row of `width` packed pixels.
[[nodiscard]] constexpr Index packed_row_bytes(Index width) {
  return width / 8 + (width % 8 != 0 ? 1 : 0);
}

/// A binary image, one bit per pixel: 0 is background, 1 is foreground. Every row starts with a new
/// byte: pixels 8 i to 8 i + 7 of row y are `data[y * stride + i]`, in the given order. `stride` is
/// the distance between rows in bytes. Unused bits of a row's last byte have no meaning; they are
/// written as 0, and bytes between rows are not written.
template <class T>
struct Packed {
  T* data = nullptr;
  Index width = 0;  // in pixels
  Index height = 0;
  Index stride = 0;
  BitOrder order = BitOrder::msb_first;

  constexpr Packed() = default;
  /// Contiguous rows.
  constexpr Packed(T* bits, Index columns, Index rows, BitOrder bit_order)
      : Packed(bits, columns, rows, packed_row_bytes(columns), bit_order) {}
  constexpr Packed(T* bits, Index columns, Index rows, Index row_bytes, BitOrder bit_order)
      : data(bits), width(columns), height(rows), stride(row_bytes), order(bit_order) {}

  [[nodiscard]] constexpr T* row(Index y) const { return data + y * stride; }
  constexpr operator Packed<const T>() const requires(!std::is_const_v<T>) {
    return {data, width, height, stride, order};
  }
};

using ConstPackedView = Packed<const std::uint8_t>;
using PackedView = Packed<std::uint8_t>;

/// Thins a packed image into another: the same pixels and number of iterations as thin() of
/// thinbench/thinning.hpp, without a byte image in between: rows are copied, with the bits of bytes
/// reversed where their order differs.
///
/// Both views must have the same size and be the same image or share no byte; their bit orders may
/// differ. Border, options, thread safety and errors as thin(); a stride below the bytes of a row
/// and an order outside the enumeration are rejected, too. Nothing is written if it throws.
THINBENCH_API int thin_packed(const Rule& rule, ConstPackedView source, PackedView destination,
                              const Thinning& thinning = {}, const Execution& execution = {});

}  // namespace thinbench
