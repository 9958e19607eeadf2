// Thinning of lists of images, for the C++ and the C interface.
#pragma once

#include <cstdint>
#include <span>

#include "thinbench/image_view.hpp"
#include "thinning/operations.hpp"

namespace thinbench::detail {

/// Image i is sources[i], and its skeleton goes to destinations[i].
struct ImageList {
  std::span<const ConstImageView> sources;
  std::span<const ImageView> destinations;
  std::span<const std::uint8_t> foregrounds;  // what is written instead of 255; none: 255
};

/// As thin_many().
int thin_list(const ThinningCall& call, const ImageList& images);

}  // namespace thinbench::detail
