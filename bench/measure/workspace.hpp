// Where input and output lie while they are timed: at the same place of a page in every process, as
// layout alone moves speed-ups.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/layout.hpp"
#include "support/byte_image.hpp"

namespace thinbench {

inline constexpr std::size_t kPage = 4096;
inline constexpr std::size_t kSourceOffset = 0;
/// Half a page from the source: a load is not taken for waiting for a store to the same place.
inline constexpr std::size_t kDestinationOffset = kPage / 2;

/// A copy of an input and an output of the same size, pages touched.
class Workspace {
 public:
  explicit Workspace(const ConstImageView& input)
      : stride_(detail::padded_row_bytes(input.width)),
        memory_(detail::make_aligned<std::uint8_t>(2 * area(input) + kPage)),
        source_{place(memory_.get(), kSourceOffset), input.width, input.height, stride_},
        destination_{place(source_.data + area(input), kDestinationOffset), input.width,
                     input.height, stride_} {
    for (Index y = 0; y < input.height; ++y) {
      std::copy_n(input.row(y), input.width, source_.row(y));
    }
  }

  [[nodiscard]] ConstImageView source() const { return source_; }
  [[nodiscard]] ImageView destination() const { return destination_; }

 private:
  /// Of one image, with a page to move within.
  [[nodiscard]] std::size_t area(const ConstImageView& input) const {
    return static_cast<std::size_t>(stride_ * input.height) + kPage;
  }

  /// The next address with this place in a page.
  static std::uint8_t* place(std::uint8_t* from, std::size_t offset) {
    const std::size_t now = reinterpret_cast<std::uintptr_t>(from) % kPage;
    return from + (offset + kPage - now) % kPage;
  }

  Index stride_;
  detail::AlignedArray<std::uint8_t> memory_;
  ImageView source_;
  ImageView destination_;
};

}  // namespace thinbench
