// Between byte images at the public edge (0 is light, anything else dark; 255 is written) and the
// planes that kernels work on.
#pragma once

#include "dispatch/exported.hpp"
#include "image/plane_view.hpp"

namespace thinbench::detail {

/// From here on bytes are written past the caches: a store would first read what it overwrites.
inline constexpr Index kStreamedBytes = Index{8} << 20;

/// Source and target have the same size. Reading writes whole rows of the plane up to the last word
/// or byte of the image, bits past the width 0; writing touches `width` bytes a row and no more.
template <class T>
struct PlaneConversion {
  void (*read)(const ConstImageView& source, const PlaneView<T>& target);
  void (*write)(const ConstPlaneView<T>& source, const ImageView& target);
  /// As `write`, for a few rows of an image of kStreamedBytes and more.
  void (*write_streamed)(const ConstPlaneView<T>& source, const ImageView& target);
};

/// Compiled for every ISA.
struct PlaneConversions {
  PlaneConversion<std::uint8_t> bytes;
  PlaneConversion<std::uint64_t> bits;
};

/// The conversion of an ISA chosen at run time.
template <class T>
[[nodiscard]] const PlaneConversion<T>& plane_conversion(Isa isa) {
  const PlaneConversions& both = kernels_of<PlaneConversions>(isa);
  if constexpr (sizeof(T) == 1) {
    return both.bytes;
  } else {
    return both.bits;
  }
}

}  // namespace thinbench::detail
