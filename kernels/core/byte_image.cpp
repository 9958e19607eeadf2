#include "core/byte_image.hpp"

#include <cstring>
#include <utility>

#include "core/layout.hpp"

namespace thinbench::detail {

ByteImage::ByteImage(Index width, Index height)
    : width_(width),
      height_(height),
      stride_(padded_row_bytes(width)),
      data_(make_aligned<std::uint8_t>(static_cast<std::size_t>(stride_ * height))) {}

ByteImage::ByteImage(const ImageView& pixels, std::function<void(void*)> release)
    : width_(pixels.width),
      height_(pixels.height),
      stride_(pixels.stride),
      data_(pixels.data, std::move(release)) {}

ByteImage copy_of(ConstImageView source) {
  ByteImage copy(source.width, source.height);
  const auto bytes = static_cast<std::size_t>(source.width);
  for (Index y = 0; y < source.height && bytes > 0; ++y) {
    std::memcpy(copy.view().row(y), source.row(y), bytes);
  }
  return copy;
}

bool equal(ConstImageView a, ConstImageView b) {
  if (a.width != b.width || a.height != b.height) return false;
  const auto bytes = static_cast<std::size_t>(a.width);
  for (Index y = 0; y < a.height && bytes > 0; ++y) {
    if (std::memcmp(a.row(y), b.row(y), bytes) != 0) return false;
  }
  return true;
}

}  // namespace thinbench::detail
