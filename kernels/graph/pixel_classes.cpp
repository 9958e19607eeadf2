#include <algorithm>
#include <bit>

#include "core/checks.hpp"
#include "core/packing.hpp"
#include "core/planes.hpp"
#include "core/variant.hpp"
#include "graph/node_pixels.hpp"
#include "thinbench/graph.hpp"

namespace thinbench {
namespace {

using detail::BitPlane;
using detail::kWordBits;
using Row = detail::NeighbourRow<std::uint64_t>;

/// Without memory for images without pixels, whatever their size.
BitPlane packed(const ConstImageView& image, Isa isa) {
  if (image.width == 0 || image.height == 0) return {};
  BitPlane plane(image.width, image.height);
  detail::plane_conversion<std::uint64_t>(isa).read(image, plane.view());
  return plane;
}

void check_result(const detail::Memory& image, const detail::Memory& result) {
  if (result.data != nullptr) detail::check(image, result, detail::InPlace::rejected);
}

PixelClass class_of(bool foreground, bool line, unsigned degree) {
  if (!foreground) return PixelClass::background;
  if (line) return PixelClass::line;
  if (degree > 1) return PixelClass::junction;
  return degree == 0 ? PixelClass::isolated : PixelClass::end;
}

/// Calls `body(x, pixel class, degree)` for the pixels of word `i` of a row.
template <class Body>
void classify_word(const detail::ConstBitPlaneView& image, Index y, Index i, const Body& body) {
  const Row row = Row::load(image.row(y) + i);
  const auto at =
      detail::degrees(Row::load(image.row(y - 1) + i), row, Row::load(image.row(y + 1) + i));
  const std::uint64_t line = detail::line_pixels(row.here, at);
  const Index pixels = std::min<Index>(kWordBits, image.width - i * kWordBits);
  for (Index x = 0; x < pixels; ++x) {
    const auto bit = [x](std::uint64_t word) { return static_cast<unsigned>(word >> x & 1); };
    const bool foreground = bit(row.here) != 0;
    const unsigned degree = foreground ? bit(at.ones) + 2 * bit(at.twos) + 4 * bit(at.fours) : 0;
    body(i * kWordBits + x, class_of(foreground, bit(line) != 0, degree), degree);
  }
}

}  // namespace

void classify_pixels(ConstImageView image, ImageView classes, ImageView degrees,
                     const Execution& execution) {
  const auto of_image = detail::memory_of("image", image);
  const auto of_classes = detail::memory_of("classes", classes);
  const auto of_degrees = detail::memory_of("degrees", degrees);
  detail::check(of_image);
  detail::require_label_size(image.width, image.height);
  check_result(of_image, of_classes);
  check_result(of_image, of_degrees);
  if (classes.data != nullptr) check_result(of_classes, of_degrees);
  const BitPlane plane = packed(image, detail::checked_isa(execution));
  const detail::ConstBitPlaneView bits = plane.view();
  for (Index y = 0; y < bits.height; ++y) {
    for (Index i = 0; i * kWordBits < bits.width; ++i) {
      classify_word(bits, y, i, [&](Index x, PixelClass pixel_class, unsigned degree) {
        if (classes.data != nullptr) classes.row(y)[x] = static_cast<std::uint8_t>(pixel_class);
        if (degrees.data != nullptr) degrees.row(y)[x] = static_cast<std::uint8_t>(degree);
      });
    }
  }
}

FullBlocks full_blocks(ConstImageView image, const Execution& execution) {
  detail::check(detail::memory_of("image", image));
  detail::require_label_size(image.width, image.height);
  const BitPlane plane = packed(image, detail::checked_isa(execution));
  const detail::ConstBitPlaneView bits = plane.view();
  FullBlocks found;
  for (Index y = 0; y < bits.height; ++y) {
    for (Index i = 0; i * kWordBits < bits.width; ++i) {
      const Row row = Row::load(bits.row(y) + i);
      const Row below = Row::load(bits.row(y + 1) + i);
      const std::uint64_t corners = row.here & row.east & below.here & below.east;
      if (found.count == 0 && corners != 0) {
        found.first = {static_cast<std::int32_t>(i * kWordBits + std::countr_zero(corners)),
                       static_cast<std::int32_t>(y)};
      }
      found.count += std::popcount(corners);
    }
  }
  return found;
}

}  // namespace thinbench
