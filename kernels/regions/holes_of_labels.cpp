// Holes of labels. Labels of one colour do not touch, so what is next to the ring around a hole has
// other colours, and the hole begins at the same pixel whether labels of its colour are inside or
// not.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/byte_image.hpp"
#include "core/checks.hpp"
#include "core/label_colours.hpp"
#include "regions/state.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

using detail::ByteImage;

/// The number of a pixel in raster order; 0, which no hole begins with, stands for none.
using Start = std::uint32_t;

/// Where the innermost hole around each pixel begins.
class HoleStarts {
 public:
  HoleStarts(Index width, Index height)
      : others_(width, height),
        parts_(detail::make_aligned<std::int32_t>(static_cast<std::size_t>(width * height))),
        starts_(detail::make_aligned<Start>(static_cast<std::size_t>(width * height))) {}

  /// Takes the holes of a colour, whose pixels `mask` has. Of nested holes the outer one begins
  /// first.
  void add(const ConstImageView& mask, Connectivity holes, const Execution& execution) {
    const ImageView others = others_.view();
    for (Index y = 0; y < mask.height; ++y) {
      std::transform(mask.row(y), mask.row(y) + mask.width, others.row(y),
                     [](std::uint8_t pixel) { return static_cast<std::uint8_t>(~pixel); });
    }
    const LabelView parts = {parts_.get(), mask.width, mask.height};
    const std::uint32_t count = label_image(others, parts, holes, LabelOrder::pixels, execution);
    if (mask.width == 0 || mask.height == 0) return;
    find_outside(parts, count);
    raise_starts(static_cast<Start>(mask.width * mask.height));
  }

  [[nodiscard]] const Start* row(Index y) const { return starts_.get() + y * others_.width(); }

  /// Removes holes around more pixels of the background than these.
  void limit_areas(const ConstLabelView& labels, std::int64_t max_area) {
    std::int32_t* const areas = parts_.get();
    std::fill_n(areas, labels.width * labels.height, 0);
    for_holes(labels, [&](Start& start) { ++areas[start]; });
    for_holes(labels, [&](Start& start) { start = areas[start] <= max_area ? start : 0; });
  }

 private:
  /// Sets `is_outside_` of the parts that reach the image border.
  void find_outside(const LabelView& parts, std::uint32_t count) {
    is_outside_.assign(count + std::size_t{1}, 0);
    const auto set = [&](Index x, Index y) {
      is_outside_[static_cast<std::size_t>(parts.row(y)[x])] = 1;
    };
    for (Index x = 0; x < parts.width; ++x) set(x, 0), set(x, parts.height - 1);
    for (Index y = 0; y < parts.height; ++y) set(0, y), set(parts.width - 1, y);
  }

  /// Parts are numbered in raster order of their first pixels.
  void raise_starts(Start pixels) {
    start_of_part_.assign(1, 0);
    const std::int32_t* const parts = parts_.get();
    Start* const starts = starts_.get();
    std::int32_t last = 0;
    Start start = 0;
    for (Start i = 0; i < pixels; ++i) {
      if (parts[i] != last) {
        last = parts[i];
        const auto part = static_cast<std::size_t>(last);
        if (part == start_of_part_.size()) start_of_part_.push_back(is_outside_[part] != 0 ? 0 : i);
        start = start_of_part_[part];
      }
      starts[i] = std::max(starts[i], start);
    }
  }

  /// Calls `body(start)` for every pixel of the background in a hole.
  template <class Body>
  void for_holes(const ConstLabelView& labels, const Body& body) {
    Start* start = starts_.get();
    for (Index y = 0; y < labels.height; ++y) {
      for (Index x = 0; x < labels.width; ++x, ++start) {
        if (labels.row(y)[x] == 0 && *start != 0) body(*start);
      }
    }
  }

  ByteImage others_;
  detail::AlignedArray<std::int32_t> parts_;  // of what has other colours
  detail::AlignedArray<Start> starts_;
  std::vector<std::uint8_t> is_outside_;
  std::vector<Start> start_of_part_;
};

/// West of its first pixel is the label around a hole.
void write_filled(const ConstLabelView& source, const HoleStarts& starts,
                  const LabelView& destination) {
  Start last = 0;
  std::int32_t label = 0;
  for (Index y = 0; y < source.height; ++y) {
    const std::int32_t* const from = source.row(y);
    const Start* const start = starts.row(y);
    for (Index x = 0; x < source.width; ++x) {
      if (start[x] != last) {
        last = start[x];
        label = last == 0 ? 0 : source.row((last - 1) / source.width)[(last - 1) % source.width];
      }
      destination.row(y)[x] = from[x] != 0 ? from[x] : label;
    }
  }
}

}  // namespace

void fill_holes_of_labels(ConstLabelView source, LabelView destination, const HoleFilling& filling,
                          const Execution& execution) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  detail::require_label_size(source.width, source.height);
  detail::require_filling(filling);
  const bool eight = filling.objects == Connectivity::eight;
  HoleStarts starts(source.width, source.height);
  detail::LabelColours(source).for_each([&](const ConstImageView& mask) {
    starts.add(mask, eight ? Connectivity::four : Connectivity::eight, execution);
  });
  if (filling.max_area != kAnyHoleArea) starts.limit_areas(source, filling.max_area);
  write_filled(source, starts, destination);
}

}  // namespace thinbench
