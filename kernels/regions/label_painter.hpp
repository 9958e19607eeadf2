// Paints label images by lane permutations. For ISA files only, where the ISA has these.
//
// Cost, per register of labels of each of two rows: a population count or a look-up for the runs
// that begin up to each lane, a load of the ids of these runs, and for each row a permutation and a
// store. No branch depends on pixels.
#pragma once

#include "core/byte_image.hpp"
#include "regions/line_writer.hpp"
#include "regions/run_sums.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

inline constexpr Index kLabelLanes = static_cast<Index>(Lanes32::size);

/// A word of a band, to be painted.
struct BandWord {
  std::uint64_t starts;
  std::uint64_t top;
  std::uint64_t bottom;
  const Label* ids;  // of the last run before the word
};

template <class Batch>
[[gnu::always_inline]] inline void store_labels(std::uint32_t* to, Batch labels, Index count) {
  if (count >= kLabelLanes) {
    labels.store_unaligned(to);
  } else {
    store_first(to, labels, count);
  }
}

/// Writes up to `count` labels of each row. The top row comes last: if the image ends with it, both
/// rows are the same memory.
template <Band band>
[[gnu::always_inline]] inline void paint_word(const BandWord& word, std::uint32_t* top,
                                              std::uint32_t* bottom, Index count) {
  for (Index x = 0; x < kWordBits; x += kLabelLanes) {
    if (x >= count) return;
    const std::uint64_t before = (std::uint64_t{1} << x) - 1;
    const auto near = Lanes32::load_unaligned(word.ids + count_bits(word.starts & before));
    const Lanes32 index = counts_upto(static_cast<std::uint32_t>(word.starts >> x));
    const auto write = [&](std::uint32_t* row, std::uint64_t pixels) {
      store_labels(row + x, permuted_where(near, index, static_cast<std::uint32_t>(pixels >> x)),
                   count - x);
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

/// Rows are painted to a buffer of this many labels first where whole cache lines are written.
inline constexpr Index kBufferedLabels = 1024;

[[gnu::always_inline]] inline bool is_large(const LabelView& labels) {
  constexpr Index label_bytes = static_cast<Index>(sizeof(Label));
  return labels.width * labels.height * label_bytes >= kNonTemporalLabelBytes;
}

template <Band band>
[[gnu::always_inline]] inline void stream_band(BandPainter<band> painter, const BandRows& rows,
                                               Index width) {
  alignas(kAlignment) std::uint32_t room[2][kBufferedLabels + LineWriter::kLine];
  LineWriter top, bottom;
  for (Index x = 0; x < width; x += kBufferedLabels) {
    const Index count = width - x < kBufferedLabels ? width - x : kBufferedLabels;
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
  const bool large = is_large(labels);
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

/// Writes up to `count` labels of objects and holes.
template <class Word>
[[gnu::always_inline]] inline void paint_row_word(const Word& word, std::uint32_t* row,
                                                  Index count) {
  for (Index x = 0; x < count; x += kLabelLanes) {
    const auto labels_of = [&](std::uint64_t pixels, std::uint64_t starts, const Label* ids) {
      const std::uint64_t before = (std::uint64_t{1} << x) - 1;
      return permuted_where(Lanes32::load_unaligned(ids + count_bits(starts & before)),
                            counts_upto(static_cast<std::uint32_t>(starts >> x)),
                            static_cast<std::uint32_t>(pixels >> x));
    };
    store_labels(row + x,
                 labels_of(word.foreground, word.foreground_starts, word.objects) |
                     labels_of(word.background, word.background_starts, word.holes),
                 count - x);
  }
}

/// Writes the next `count` labels of a row, whole words except at its end.
template <Band band>
[[gnu::always_inline]] inline void paint_row(RowReader<band>& reader, std::uint32_t* row,
                                             Index count) {
  for (; count > 0; count -= kWordBits, row += kWordBits) {
    paint_row_word(reader.next(), row, count < kWordBits ? count : kWordBits);
  }
}

template <Band band>
[[gnu::always_inline]] inline void stream_row(RowReader<band>& reader, std::uint32_t* row,
                                              Index width) {
  alignas(kAlignment) std::uint32_t room[kBufferedLabels + LineWriter::kLine];
  LineWriter writer;
  for (Index x = 0; x < width; x += kBufferedLabels) {
    const Index count = width - x < kBufferedLabels ? width - x : kBufferedLabels;
    std::uint32_t* const labels = LineWriter::start_in(room, row + x);
    paint_row(reader, labels, count);
    writer.write(row + x, labels, count);
  }
  writer.flush();
}

template <Band band>
[[gnu::always_inline]] inline void paint_rows(const Objects& objects, const Background& background,
                                              const LabelView& labels) {
  const bool large = is_large(labels);
  for (Index y = 0; y < labels.height; ++y) {
    RowReader<band> reader(objects, background, y);
    auto* const row = reinterpret_cast<std::uint32_t*>(labels.row(y));
    if (large) {
      stream_row(reader, row, labels.width);
    } else {
      paint_row(reader, row, labels.width);
    }
  }
  if (large) finish_non_temporal_stores();
}

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
