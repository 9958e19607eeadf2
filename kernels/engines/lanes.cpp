// Small images, one per lane: with 32-bit lanes and AVX-512, a register holds a row of 16 images.
//
// No neighbour crosses a lane, so west and east are plain shifts. A group (1.8 KB for 28 x 28
// pixels) stays in the L1 cache from packing to unpacking. It is thinned in place until none of its
// images changes; further iterations do not change an image that is done.
//
// The next group is prefetched.
// What was tried: docs/experiments.md#batches.
#include "engines/lanes.hpp"

#include "core/exported.hpp"
#include "engines/lane_packing.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

/// Images in lanes of T, each in kElements adjacent ones.
template <class T, Index elements>
struct Lanes {
  using Element = T;
  static constexpr Index kElements = elements;
  static constexpr Index kRow = static_cast<Index>(BatchOf<T>::size);  // elements of a register
  static constexpr Index kImages = kRow / elements;
};

/// A group of images: rows of one register each, with margin rows above and below.
template <class Lanes>
struct LaneRows {
  using Element = typename Lanes::Element;

  Element* data;  // row 0

  [[gnu::always_inline]] Element* at(Index y) const { return data + y * Lanes::kRow; }
};

template <class Lanes>
void clear(const LaneRows<Lanes>& rows, Index first, Index last) {
  for (auto* at = rows.at(first); at != rows.at(last); ++at) *at = 0;
}

/// Calls `part(image, element, x, width)` for each element of a register row of a group: it holds
/// pixels [x, x + width) of the image.
template <class Lanes, class Part>
[[gnu::always_inline]] inline void for_parts(Index images, Index width, const Part& part) {
  constexpr Index bits = 8 * static_cast<Index>(sizeof(typename Lanes::Element));
  for (Index image = 0; image < images; ++image) {
    for (Index x = 0, i = 0; i < Lanes::kElements; x += bits, ++i) {
      const Index rest = width - x;
      part(image, image * Lanes::kElements + i, x, rest < bits ? rest : bits);
    }
  }
}

template <class Lanes>
void read_group(const ConstStackView& source, Index first, Index images,
                const LaneRows<Lanes>& rows) {
  const Index height = source.height;
  const Index stride = source.stride;
  for_parts<Lanes>(
      images, source.width,
      [&](Index image, Index element, Index x, Index width) __attribute__((always_inline)) {
        const std::uint8_t* from = source.data + (first + image) * source.image_stride + x;
        for (Index y = 0; y < height; ++y) {
          rows.at(y)[element] = pack_pixels<typename Lanes::Element>(from + y * stride, width);
        }
      });
}

template <class Lanes>
void write_group(const LaneRows<Lanes>& rows, Index first, Index images, const StackView& target) {
  const Index height = target.height;
  const Index stride = target.stride;
  for_parts<Lanes>(
      images, target.width,
      [&](Index image, Index element, Index x, Index width) __attribute__((always_inline)) {
        std::uint8_t* to = target.data + (first + image) * target.image_stride + x;
        for (Index y = 0; y < height; ++y) {
          unpack_pixels(rows.at(y)[element], to + y * stride, width);
        }
      });
}

/// Exchanges foreground and background, except the bits of a row that hold no pixel.
template <class Lanes>
void complement(const LaneRows<Lanes>& rows, Index height,
                const typename Lanes::Element* no_pixels) {
  for (Index y = 0; y < height; ++y) {
    for (Index i = 0; i < Lanes::kRow; ++i) {
      rows.at(y)[i] = static_cast<typename Lanes::Element>(~(rows.at(y)[i] ^ no_pixels[i]));
    }
  }
}

/// Sets the bits that must not change in a row of a register: those of the first and the last
/// column if the border is kept, and all that hold no pixel of `images` images.
template <class Lanes>
void set_fixed(const LaneJob& job, Index images, typename Lanes::Element* fixed) {
  using Element = typename Lanes::Element;
  const Index width = job.source.width;
  const Index margin = job.keep_border ? 1 : 0;
  for (Index i = 0; i < Lanes::kRow; ++i) fixed[i] = static_cast<Element>(~Element{0});
  for_parts<Lanes>(images, width, [&](Index, Index element, Index x, Index part_width) {
    for (Index i = 0; i < part_width; ++i) {
      if (x + i < margin || x + i >= width - margin) continue;
      fixed[element] = static_cast<Element>(fixed[element] & ~(Element{1} << i));
    }
  });
}

/// Prefetches the group that begins with image `first`; nothing if `first` >= `last`.
template <class Lanes>
Prefetcher prefetcher_of(const LaneJob& job, Index first, Index last) {
  if (first >= last) return {job.source.data, job.target.data, 0};
  const Index images = last - first < Lanes::kImages ? last - first : Lanes::kImages;
  const Index from = job.source.image_stride;
  const Index to = job.target.image_stride;
  return {job.source.data + first * from, job.target.data + first * to,
          images * (from < to ? from : to)};
}

/// Iterates a rule without a function of its own for that.
int repeat_scans(const BoundRule& rule, const ColumnScan& scan, int max_iterations,
                 Prefetcher& prefetcher) {
  int iterations = 0;
  bool changed = true;
  while (changed && iterations < max_iterations) {
    changed = false;
    for (std::size_t sub = 0; sub < rule.sub_iterations; ++sub) {
      changed = rule.scans[sub](scan) != 0 || changed;
      for (Index y = 0; y < scan.rows; ++y) prefetcher.prefetch_line();
    }
    ++iterations;
  }
  return iterations;
}

/// Iterates until no image of a group changes; returns the number of iterations.
template <class Lanes>
int thin_group(const LaneJob& job, const LaneRows<Lanes>& rows, const void* fixed,
               Prefetcher prefetcher) {
  constexpr Index stride = Lanes::kRow * static_cast<Index>(sizeof(typename Lanes::Element));
  const Index margin = job.keep_border ? 1 : 0;
  const Index count = job.source.height - 2 * margin;
  if (count <= 0) return 1;
  auto* const first = rows.at(margin);
  const ColumnScan scan = {first, stride, first, stride, count, count, fixed};
  if (job.rule->repeat != nullptr) return job.rule->repeat(scan, job.max_iterations, prefetcher);
  return repeat_scans(*job.rule, scan, job.max_iterations, prefetcher);
}

template <class Lanes>
int thin_lanes(const LaneJob& job, Index first, Index last, void* scratch) {
  using Element = typename Lanes::Element;
  const LaneRows<Lanes> rows = {static_cast<Element*>(scratch) + kMarginRows * Lanes::kRow};
  const bool has_fixed = job.keep_border || job.rule->adds_pixels;
  alignas(64) Element fixed[Lanes::kRow];
  set_fixed<Lanes>(job, Lanes::kImages, fixed);
  clear(rows, -kMarginRows, 0);
  clear(rows, job.source.height, job.source.height + kMarginRows);
  int max_taken = 0;
  for (Index image = first; image < last; image += Lanes::kImages) {
    const Index images = last - image < Lanes::kImages ? last - image : Lanes::kImages;
    if (images < Lanes::kImages) {
      set_fixed<Lanes>(job, images, fixed);
      clear(rows, 0, job.source.height);
    }
    read_group(job.source, image, images, rows);
    if (job.complemented) complement(rows, job.source.height, fixed);
    const int iterations = thin_group(job, rows, has_fixed ? fixed : nullptr,
                                      prefetcher_of<Lanes>(job, image + images, last));
    if (job.complemented) complement(rows, job.source.height, fixed);
    write_group(rows, image, images, job.target);
    if (iterations > max_taken) max_taken = iterations;
  }
  return max_taken;
}

int thin_images(const LaneJob& job, Index first, Index last, void* scratch) {
  switch (lane_layout(job.source.width)) {
    case Layout::lanes_32:
      return thin_lanes<Lanes<std::uint32_t, 1>>(job, first, last, scratch);
    case Layout::lanes_64:
      return thin_lanes<Lanes<std::uint64_t, 1>>(job, first, last, scratch);
    default:
      return thin_lanes<Lanes<std::uint64_t, 2>>(job, first, last, scratch);
  }
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const LaneKernels Exported<LaneKernels, kThisIsa>::kKernels = {&thin_images};

}  // namespace thinbench::detail
