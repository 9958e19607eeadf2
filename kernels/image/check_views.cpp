#include "image/check_views.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>

namespace thinbench::detail {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument(why);
}

std::string size_text(const ConstImageView& view) {
  return std::to_string(view.width) + " x " + std::to_string(view.height);
}

void check_view(const ConstImageView& view, const std::string& name) {
  if (view.width < 0 || view.height < 0) refuse(name + " has the size " + size_text(view));
  if (view.stride < view.width) {
    refuse(name + " has a stride of " + std::to_string(view.stride) +
           " bytes, below its width of " + std::to_string(view.width));
  }
  if (view.height > 0 && view.stride > PTRDIFF_MAX / view.height) {
    refuse(name + " spans more memory than there is: " + size_text(view) + ", stride " +
           std::to_string(view.stride));
  }
  if (view.data == nullptr && view.width > 0 && view.height > 0) refuse(name + " has no data");
}

bool same_image(const ConstImageView& a, const ConstImageView& b) {
  return a.data == b.data && a.stride == b.stride;
}

/// Whether two views of one buffer lie side by side: with equal strides, the columns of one begin
/// after those of the other end and end before they begin again in the next row.
bool side_by_side(const ConstImageView& a, const ConstImageView& b) {
  if (a.stride != b.stride) return false;
  const Index apart = b.data - a.data;
  const Index column = (apart % a.stride + a.stride) % a.stride;
  return column >= a.width && column + b.width <= a.stride;
}

bool overlap(const ConstImageView& a, const ConstImageView& b) {
  if (a.width == 0 || a.height == 0) return false;
  const auto begin = [](const ConstImageView& v) {
    return reinterpret_cast<std::uintptr_t>(v.data);
  };
  const auto end = [](const ConstImageView& v) {
    return reinterpret_cast<std::uintptr_t>(v.row(v.height - 1) + v.width);
  };
  return begin(a) < end(b) && begin(b) < end(a) && !side_by_side(a, b);
}

}  // namespace

void check_views(const ConstImageView& source, const ConstImageView& destination, InPlace in_place) {
  check_view(source, "source");
  check_view(destination, "destination");
  if (source.width != destination.width || source.height != destination.height) {
    refuse("source is " + size_text(source) + " and destination " + size_text(destination) +
           "; they must have one size");
  }
  if (!overlap(source, destination)) return;
  if (in_place == InPlace::rejected) refuse("source and destination overlap");
  if (!same_image(source, destination)) {
    refuse("source and destination overlap without being the same image");
  }
}

}  // namespace thinbench::detail
