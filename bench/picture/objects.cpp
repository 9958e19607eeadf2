#include "picture/objects.hpp"

#include <algorithm>

namespace thinbench {

ByteImage objects_of(ByteImage grey, int threshold, bool invert) {
  const ImageView view = grey.view();
  for (Index y = 0; y < view.height; ++y) {
    std::uint8_t* row = view.row(y);
    for (Index x = 0; x < view.width; ++x) row[x] = (row[x] >= threshold) != invert ? 255 : 0;
  }
  return grey;
}

Index object_pixels(ConstImageView image) {
  Index count = 0;
  for (Index y = 0; y < image.height; ++y) {
    count += image.width - std::count(image.row(y), image.row(y) + image.width, std::uint8_t{0});
  }
  return count;
}

}  // namespace thinbench
