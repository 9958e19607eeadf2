// Label images by words, painted by lane permutations where the ISA has them. Compiled for every
// ISA.
//
// Cost of painting, per register of 4-byte labels of each of two rows: a population count or a
// look-up for the runs that begin up to each lane, a load of the ids of these runs, and for each
// row a permutation and a store. There are no branches that depend on pixels. Finding and joining
// runs is that of bitpacked_labels.cpp.
#include "core/byte_image.hpp"
#include "core/exported.hpp"
#include "regions/line_writer.hpp"
#include "regions/run_blocks.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

constexpr Index kLanes = static_cast<Index>(Lanes32::size);

template <Band band>
void count(const ConstBitPlaneView& image, Label* first) {
  count_runs<band>(image, 0, first);
}

/// Narrower images are faster word by word.
constexpr Index kMinBlockWidth = 193;

template <Band band>
[[gnu::always_inline]] inline void unite_with_above(const ConstBitPlaneView& image, Index number,
                                                    const RunForest& runs) {
  if constexpr (kHasRunBlocks) {
    if (image.width >= kMinBlockWidth) {
      unite_band_in_blocks<band, WordBatch>(image, number, runs);
      return;
    }
  }
  unite_band<band>(image, number, runs);
}

template <Band band>
void unite_all(const ConstBitPlaneView& image, const RunForest& runs) {
  unite_runs<band>(image, runs, [&](Index number) { unite_with_above<band>(image, number, runs); });
}

template <Band band>
Label number(const ConstBitPlaneView& image, const RunForest& runs) {
  return number_runs<band>(image, runs);
}

template <Band band>
void sum(const ConstBitPlaneView& image, const RunForest& runs, Region* objects) {
  sum_runs<band>(image, runs, objects);
}

/// A word of a band, to be painted.
struct BandWord {
  std::uint64_t starts;
  std::uint64_t top;
  std::uint64_t bottom;
  const Label* ids;  // of the last run before the word
};

/// Writes up to `count` labels of each row. The top row comes last: if the image ends with it, both
/// rows are the same memory.
template <Band band>
[[gnu::always_inline]] inline void paint_word(const BandWord& word, std::uint32_t* top,
                                              std::uint32_t* bottom, Index count) {
  for (Index x = 0; x < kWordBits; x += kLanes) {
    if (x >= count) return;
    const std::uint64_t before = (std::uint64_t{1} << x) - 1;
    const auto near = Lanes32::load_unaligned(word.ids + count_bits(word.starts & before));
    const Lanes32 index = counts_upto(static_cast<std::uint32_t>(word.starts >> x));
    const auto write = [&](std::uint32_t* row, std::uint64_t pixels) {
      const Lanes32 labels = permuted_where(near, index, static_cast<std::uint32_t>(pixels >> x));
      if (x + kLanes <= count) {
        labels.store_unaligned(row + x);
      } else {
        store_first(row + x, labels, count - x);
      }
    };
    if constexpr (band == Band::pair) write(bottom, word.bottom);
    write(top, word.top);
  }
}

/// Paints a band from the left.
template <Band band>
class BandPainter {
 public:
  [[gnu::always_inline]] BandPainter(const ConstBitPlaneView& image, Index number,
                                     const RunForest& runs)
      : bits_(image, number), ids_(runs.ids + runs.first[number] - 1) {}

  /// Writes the next `count` labels of each row, whole words except at the end of the row.
  [[gnu::always_inline]] void paint(std::uint32_t* top, std::uint32_t* bottom, Index count) {
    const Index whole = count / kWordBits;
    for (Index i = 0; i < whole; ++i, top += kWordBits, bottom += kWordBits) {
      paint_word<band>(next(), top, bottom, kWordBits);
    }
    if (count % kWordBits != 0) paint_word<band>(next(), top, bottom, count % kWordBits);
  }

 private:
  [[gnu::always_inline]] BandWord next() {
    const BandWord word = {bits_.starts(word_), bits_.top(word_), bits_.bottom(word_), ids_};
    ids_ += count_bits(word.starts);
    ++word_;
    return word;
  }

  BandBits<band> bits_;
  const Label* ids_;
  Index word_ = 0;
};

/// Rows of a band, as memory; the same one twice where there is only one.
struct BandRows {
  std::uint32_t* top;
  std::uint32_t* bottom;
};

[[gnu::always_inline]] inline BandRows rows_of_band(Band band, const LabelView& labels,
                                                    Index number) {
  const Index y = number * rows_of(band);
  const Index last = y + rows_of(band) - 1;
  const auto row = [&](Index at) { return reinterpret_cast<std::uint32_t*>(labels.row(at)); };
  return {row(y), row(last < labels.height ? last : y)};
}

/// Paints to a buffer first, from which whole cache lines are written.
template <Band band>
[[gnu::always_inline]] inline void stream_band(BandPainter<band> painter, const BandRows& rows,
                                               Index width) {
  constexpr Index labels = 1024;
  alignas(kAlignment) std::uint32_t room[2][labels + LineWriter::kLine];
  LineWriter top, bottom;
  for (Index x = 0; x < width; x += labels) {
    const Index count = width - x < labels ? width - x : labels;
    std::uint32_t* const of_top = LineWriter::start_in(room[0], rows.top + x);
    std::uint32_t* const of_bottom = LineWriter::start_in(room[1], rows.bottom + x);
    painter.paint(of_top, of_bottom, count);
    top.write(rows.top + x, of_top, count);
    if (rows.top != rows.bottom) bottom.write(rows.bottom + x, of_bottom, count);
  }
  top.flush();
  bottom.flush();
}

template <Band band>
[[gnu::always_inline]] inline void paint_bands(const ConstBitPlaneView& image,
                                               const RunForest& runs, const LabelView& labels) {
  constexpr Index label_bytes = static_cast<Index>(sizeof(Label));
  const bool large = labels.width * labels.height * label_bytes >= kNonTemporalLabelBytes;
  for (Index number = 0; number < bands_of(band, image.height); ++number) {
    const BandRows rows = rows_of_band(band, labels, number);
    BandPainter<band> painter(image, number, runs);
    if (large) {
      stream_band(painter, rows, image.width);
    } else {
      painter.paint(rows.top, rows.bottom, image.width);
    }
  }
  if (large) finish_non_temporal_stores();
}

template <Band band>
void paint(const ConstBitPlaneView& image, const RunForest& runs, const LabelView& labels) {
  if constexpr (kHasLanePermute) {
    paint_bands<band>(image, runs, labels);
  } else {
    paint_runs<band>(image, runs, labels);
  }
}

template <Band band>
constexpr LabelKernels kKernels = {&count<band>, &unite_all<band>, &number<band>, &sum<band>,
                                   &paint<band>};

template <class Word>
[[gnu::always_inline]] inline void paint_row_word(const Word& word, std::uint32_t* row,
                                                  Index count) {
  for (Index x = 0; x < count; x += kLanes) {
    const auto labels_of = [&](std::uint64_t pixels, std::uint64_t starts, const Label* ids) {
      const std::uint64_t before = (std::uint64_t{1} << x) - 1;
      return permuted_where(Lanes32::load_unaligned(ids + count_bits(starts & before)),
                            counts_upto(static_cast<std::uint32_t>(starts >> x)),
                            static_cast<std::uint32_t>(pixels >> x));
    };
    const Lanes32 labels = labels_of(word.foreground, word.foreground_starts, word.objects) |
                           labels_of(word.background, word.background_starts, word.holes);
    if (x + kLanes <= count) {
      labels.store_unaligned(row + x);
    } else {
      store_first(row + x, labels, count - x);
    }
  }
}

template <Band band>
[[gnu::always_inline]] inline void paint_row(const Objects& objects, const Background& background,
                                             Index y, std::uint32_t* row) {
  RowReader<band> reader(objects, background, y);
  for (Index left = objects.image.width; left > 0; left -= kWordBits, row += kWordBits) {
    paint_row_word(reader.next(), row, left < kWordBits ? left : kWordBits);
  }
}

void invert(const ConstBitPlaneView& image, const BitPlaneView& background) {
  write_background(image, background);
}

void count_background(const ConstBitPlaneView& background, Label* first) {
  count_runs<Band::row>(background, 1, first);
}

void unite_holes(const Background& background) {
  const auto& [image, runs] = background;
  unite_background(image, runs, [&](Index y) { unite_with_above<Band::row>(image, y, runs); });
}

Label number_holes(const Background& background, Label objects) {
  background.runs.ids[0] = 0;
  return number_in_order(background.runs, 1, background.runs.first[background.image.height],
                         objects);
}

void sum_all(const Objects& objects, const Background& background, Region* regions) {
  sum_all_runs<Band::pair>(objects, background, regions);
}

template <Band band>
void paint_all(const Objects& objects, const Background& background, const LabelView& labels) {
  if constexpr (kHasLanePermute) {
    for (Index y = 0; y < labels.height; ++y) {
      paint_row<band>(objects, background, y, reinterpret_cast<std::uint32_t*>(labels.row(y)));
    }
  } else {
    paint_all_runs(objects, background, labels);
  }
}

constexpr HoleKernels kHoleKernels = {&invert,       &count_background, &unite_holes,
                                      &number_holes, &sum_all,          &paint_all<Band::pair>};

}  // namespace

}  // namespace THINBENCH_ISA

template <>
constinit const LabelEngine Exported<LabelEngine, kThisIsa>::kKernels = {
    THINBENCH_ISA::kKernels<Band::pair>, THINBENCH_ISA::kKernels<Band::row>,
    THINBENCH_ISA::kHoleKernels};

}  // namespace thinbench::detail
