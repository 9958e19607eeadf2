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
#include "thinning/engines/word_scan.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

/// Images up to 32 or 64 pixels wide, in lanes of T.
template <class T>
struct PlainLanes {
  using Word = xsimd::batch<T, Architecture>;
  using Element = T;
  static constexpr Index kImages = static_cast<Index>(Word::size);
  static constexpr Index kElements = 1;  // per image

  [[gnu::always_inline]] static RowTriple<Word> with_neighbours(Word row) {
    return {row << 1, row, row >> 1};
  }
};

/// Images up to 128 pixels wide, each in two adjacent lanes.
struct PairedLanes {
  using Word = WordBatch;
  using Element = std::uint64_t;
  static constexpr Index kImages = static_cast<Index>(Word::size) / 2;
  static constexpr Index kElements = 2;

  [[gnu::always_inline]] static RowTriple<Word> with_neighbours(Word row) {
    return {west_neighbour<1>(row, previous_in_pair(row)), row,
            east_neighbour<1>(row, next_in_pair(row))};
  }
};

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

/// The mask of pixels of a row that may change: all, or all but the first and last of each image.
template <class Lanes>
typename Lanes::Word free_pixels(Index width, bool keep_border) {
  using Element = typename Lanes::Element;
  constexpr Index bits = 8 * static_cast<Index>(sizeof(Element));
  alignas(64) Element pattern[LaneRows<Lanes>::kRow];
  for (Index i = 0; i < LaneRows<Lanes>::kRow; ++i) {
    const Index x = i % Lanes::kElements * bits;
    pattern[i] = static_cast<Element>(~Element{0});
    if (!keep_border) continue;
    if (x == 0) pattern[i] = static_cast<Element>(pattern[i] & ~Element{1});
    const Index end = width - 1 - x;
    if (0 <= end && end < bits) {
      pattern[i] = static_cast<Element>(pattern[i] & ~(Element{1} << end));
    }
  }
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
FreeArea<Lanes> free_area(const LaneJob& job) {
  const Index margin = job.keep_border ? 1 : 0;
  return {margin, job.source.height - margin,
          free_pixels<Lanes>(job.source.width, job.keep_border)};
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

template <class Rule, class Lanes, int... subs>
int thin_group(const LaneRows<Lanes>& rows, const FreeArea<Lanes>& area, int max_iterations,
               Prefetcher prefetcher, std::integer_sequence<int, subs...>) {
  int iterations = 0;
  bool changed = true;
  while (changed && iterations < max_iterations) {
    changed = false;
    ((changed = run_sub_iteration<Rule, subs>(rows, area, prefetcher) || changed), ...);
    ++iterations;
  }
  return iterations;
}

template <class Rule, class Lanes>
int thin_lanes(const LaneJob& job, Index first, Index last, void* scratch) {
  using Element = typename Lanes::Element;
  constexpr auto subs = std::make_integer_sequence<int, Rule::kSubIterations>{};
  const LaneRows<Lanes> rows = {static_cast<Element*>(scratch) +
                                kMarginRows * LaneRows<Lanes>::kRow};
  const FreeArea<Lanes> area = free_area<Lanes>(job);
  clear(rows, -kMarginRows, 0);
  clear(rows, job.source.height, job.source.height + kMarginRows);
  int max_taken = 0;
  for (Index image = first; image < last; image += Lanes::kImages) {
    const Index images = last - image < Lanes::kImages ? last - image : Lanes::kImages;
    read_group(job.source, image, images, rows);
    const int iterations = thin_group<Rule>(rows, area, job.max_iterations,
                                            prefetcher_of<Lanes>(job, image + images, last), subs);
    write_group(rows, image, images, job.target);
    if (iterations > max_taken) max_taken = iterations;
  }
  return max_taken;
}

template <class Rule>
int thin_images(const LaneJob& job, Index first, Index last, void* scratch) {
  const Index width = job.source.width;
  if (width <= 32) return thin_lanes<Rule, PlainLanes<std::uint32_t>>(job, first, last, scratch);
  if (width <= 64) return thin_lanes<Rule, PlainLanes<std::uint64_t>>(job, first, last, scratch);
  return thin_lanes<Rule, PairedLanes>(job, first, last, scratch);
}

consteval LaneKernels make_kernels() {
  LaneKernels kernels{};
  for_each_parallel_rule(
      [&]<class Type>(Rule rule) { kernels.by_rule[rule] = &thin_images<Type>; });
  return kernels;
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const LaneKernels Exported<LaneKernels, kThisIsa>::kKernels = make_kernels();

}  // namespace thinbench::detail
