// Small images, one per lane: with 32-bit lanes and AVX-512, a register holds a row of 16 images.
//
// No neighbour crosses a lane, so west and east are plain shifts. Cost per row of a group and
// sub-iteration: 1 load, 1 store, 2 shifts, the rule's gates, 1 to keep the border, 1 to detect
// changes, 2 prefetches. A group (1.8 KB for 28 x 28 pixels) stays in the L1 cache from packing to
// unpacking. It is thinned in place until none of its images changes; further iterations do not
// change an image that is done.
//
// The next group is prefetched: docs/experiments.md#prefetching-the-next-group.
// Measured, not adopted: docs/experiments.md#packing-from-whole-loads.
#include "thinning/engines/lane_kernels.hpp"

#include "dispatch/exported.hpp"
#include "thinning/engines/lane_packing.hpp"
#include "thinning/engines/layouts.hpp"
#include "thinning/engines/word_scan.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

/// A group of images: rows of one register each, with margin rows above and below.
template <class Lanes>
struct LaneRows {
  using Word = typename Lanes::Word;
  using Element = typename Lanes::Element;
  static constexpr Index kRow = static_cast<Index>(Word::size);

  Element* data;  // row 0

  [[gnu::always_inline]] Element* at(Index y) const { return data + y * kRow; }
  [[gnu::always_inline]] RowTriple<Word> row(Index y) const {
    return Lanes::with_neighbours(Word::load_aligned(at(y)));
  }

  template <class Rule>
  [[gnu::always_inline]] RowTriple<Word> features(Index, const RowTriple<Word>& above,
                                                  const RowTriple<Word>& here,
                                                  const RowTriple<Word>& below) const {
    return Lanes::with_neighbours(Rule::feature(cross(above.centre, here, below.centre)));
  }
};

template <class Lanes>
void clear(const LaneRows<Lanes>& rows, Index first, Index last) {
  for (Index y = first; y < last; ++y) {
    typename Lanes::Word(typename Lanes::Element{0}).store_aligned(rows.at(y));
  }
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
  if (images < Lanes::kImages) clear(rows, 0, height);
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

/// The mask of pixels of a row that may change: those of `images` images, without the first and
/// last column if the border is kept.
template <class Lanes>
typename Lanes::Word free_pixels(Index images, Index width, bool keep_border) {
  using Element = typename Lanes::Element;
  alignas(64) Element pattern[LaneRows<Lanes>::kRow] = {};
  const Index margin = keep_border ? 1 : 0;
  for_parts<Lanes>(images, width, [&](Index, Index element, Index x, Index part_width) {
    for (Index i = 0; i < part_width; ++i) {
      if (x + i < margin || x + i >= width - margin) continue;
      pattern[element] = static_cast<Element>(pattern[element] | Element{1} << i);
    }
  });
  return Lanes::Word::load_aligned(pattern);
}

/// The pixels that may change.
template <class Lanes>
struct FreeArea {
  Index first;                  // row
  Index last;                   // row after the last
  typename Lanes::Word pixels;  // of each row
};

template <class Lanes>
FreeArea<Lanes> free_area(const LaneJob& job, Index images) {
  const Index margin = job.keep_border ? 1 : 0;
  return {margin, job.source.height - margin,
          free_pixels<Lanes>(images, job.source.width, job.keep_border)};
}

/// Prefetches the memory that the next group will read and write, one cache line at a time.
struct Prefetcher {
  const std::uint8_t* source;
  const std::uint8_t* target;
  Index bytes;
  Index next = 0;

  [[gnu::always_inline]] void prefetch_line() {
    constexpr Index line = 64;
    if (next >= bytes) return;
    __builtin_prefetch(source + next, 0, 2);
    __builtin_prefetch(target + next, 1, 2);
    next += line;
  }
};

/// Prefetches the group that begins with image `first`; nothing if `first` >= `last`.
template <class Lanes>
Prefetcher prefetcher_of(const LaneJob& job, Index first, Index last) {
  const Index images = last - first < Lanes::kImages ? last - first : Lanes::kImages;
  const Index from = job.source.image_stride;
  const Index to = job.target.image_stride;
  return {job.source.data + first * from, job.target.data + first * to,
          images * (from < to ? from : to)};
}

/// Applies one sub-iteration in place. True if a pixel changed.
template <class Rule, int sub, class Lanes>
[[gnu::always_inline]] inline bool run_sub_iteration(const LaneRows<Lanes>& rows,
                                                     const FreeArea<Lanes>& area,
                                                     Prefetcher& shared) {
  Prefetcher prefetcher = shared;  // a local copy, which stores cannot alias
  using Word = typename Lanes::Word;
  const Rule rule{};
  const Word pixels = area.pixels;
  Word changed(typename Lanes::Element{0});
  Window<Rule, LaneRows<Lanes>> window(rows, area.first);
  for (Index y = area.first; y < area.last; ++y) {
    const Word before = window.centre();
    const Word next = ternary(window.template next<sub>(rule, rows, y), before, pixels,
                              [](auto a, auto b, auto c) { return b ^ ((a ^ b) & c); });
    next.store_aligned(rows.at(y));
    prefetcher.prefetch_line();
    changed = ternary(changed, before, next, [](auto a, auto b, auto c) { return a | (b ^ c); });
    window.move_down();
  }
  shared = prefetcher;
  return any_bit(changed);
}

/// Runs iterations of a built-in rule on a group.
template <class Rule>
struct BuiltInIteration {
  template <class Lanes>
  bool operator()(const LaneRows<Lanes>& rows, const FreeArea<Lanes>& area,
                  Prefetcher& prefetcher) const {
    return [&]<int... subs>(std::integer_sequence<int, subs...>) {
      bool changed = false;
      ((changed = run_sub_iteration<Rule, subs>(rows, area, prefetcher) || changed), ...);
      return changed;
    }
    (std::make_integer_sequence<int, Rule::kSubIterations>{});
  }
};

/// The same for a custom rule.
struct CustomIteration {
  const BoundRule& rule;

  template <class Lanes>
  bool operator()(const LaneRows<Lanes>& rows, const FreeArea<Lanes>& area, Prefetcher&) const {
    using Element = typename Lanes::Element;
    if (area.first >= area.last) return false;
    alignas(64) Element fixed[LaneRows<Lanes>::kRow];
    (~area.pixels).store_aligned(fixed);
    constexpr Index stride = LaneRows<Lanes>::kRow * static_cast<Index>(sizeof(Element));
    Element* const first = rows.at(area.first);
    const Index count = area.last - area.first;
    bool changed = false;
    for (int sub = 0; sub < rule.sub_iterations; ++sub) {
      const BoundScan& scan = rule.scans[static_cast<std::size_t>(sub)];
      changed = scan({first, stride, first, stride, count, count, fixed}) != 0 || changed;
    }
    return changed;
  }
};

template <class Iteration, class Lanes>
int thin_group(const Iteration& iterate_once, const LaneRows<Lanes>& rows,
               const FreeArea<Lanes>& area, int max_iterations, Prefetcher prefetcher) {
  int iterations = 0;
  bool changed = true;
  while (changed && iterations < max_iterations) {
    changed = iterate_once(rows, area, prefetcher);
    ++iterations;
  }
  return iterations;
}

template <class Lanes, class Iteration>
int thin_lanes(const Iteration& iterate_once, const LaneJob& job, Index first, Index last,
               void* scratch) {
  using Element = typename Lanes::Element;
  const LaneRows<Lanes> rows = {static_cast<Element*>(scratch) +
                                kMarginRows * LaneRows<Lanes>::kRow};
  FreeArea<Lanes> area = free_area<Lanes>(job, Lanes::kImages);
  clear(rows, -kMarginRows, 0);
  clear(rows, job.source.height, job.source.height + kMarginRows);
  int max_taken = 0;
  for (Index image = first; image < last; image += Lanes::kImages) {
    const Index images = last - image < Lanes::kImages ? last - image : Lanes::kImages;
    if (images < Lanes::kImages) area = free_area<Lanes>(job, images);
    read_group(job.source, image, images, rows);
    const int iterations = thin_group(iterate_once, rows, area, job.max_iterations,
                                      prefetcher_of<Lanes>(job, image + images, last));
    write_group(rows, image, images, job.target);
    if (iterations > max_taken) max_taken = iterations;
  }
  return max_taken;
}

template <class Iteration>
int thin_images(const Iteration& iterate_once, const LaneJob& job, Index first, Index last,
                void* scratch) {
  switch (lane_layout(job.source.width)) {
    case Layout::lanes_32:
      return thin_lanes<PlainLanes<std::uint32_t>>(iterate_once, job, first, last, scratch);
    case Layout::lanes_64:
      return thin_lanes<PlainLanes<std::uint64_t>>(iterate_once, job, first, last, scratch);
    default:
      return thin_lanes<PairedLanes>(iterate_once, job, first, last, scratch);
  }
}

template <class Rule>
int thin_built_in(const LaneJob& job, Index first, Index last, void* scratch) {
  return thin_images(BuiltInIteration<Rule>{}, job, first, last, scratch);
}

int thin_custom(const LaneJob& job, Index first, Index last, void* scratch) {
  return thin_images(CustomIteration{*job.rule}, job, first, last, scratch);
}

consteval LaneKernels make_kernels() {
  LaneKernels kernels{};
  kernels.custom = &thin_custom;
  for_each_parallel_rule(
      [&]<class Type>(Rule rule) { kernels.by_rule[rule] = &thin_built_in<Type>; });
  return kernels;
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const LaneKernels Exported<LaneKernels, kThisIsa>::kKernels = make_kernels();

}  // namespace thinbench::detail
