// Paints label images by lane permutations. For ISA files only, where the ISA has these.
//
// Cost, per register of labels of each of two rows: a population count or a look-up for the runs
// that begin up to each lane, a load of the ids of these runs, and for each row a permutation and a
// store. No branch depends on pixels.
#pragma once

#include "core/byte_image.hpp"
#include "regions/run_sums.hpp"
#include "simd/vector.hpp"

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
template <BandKind band>
[[gnu::always_inline]] inline void paint_word(const BandWord& word, std::uint32_t* top,
                                              std::uint32_t* bottom, Index count) {
  for (Index next = 0; next < kWordBits; next += kLabelLanes) {
    if (next >= count) return;
    // Where stores of parts of registers are slow, the last one overlaps that before it.
    const bool is_last = !kHasMaskedBytes && next + kLabelLanes > count && count >= kLabelLanes;
    const Index x = is_last ? count - kLabelLanes : next;
    // From the run of the first lane on: as many lanes as runs at most.
    const std::uint64_t upto_first = (std::uint64_t{2} << x) - 1;
    const auto near = Lanes32::load_unaligned(word.ids + count_bits(word.starts & upto_first));
    const Lanes32 index =
        counts_upto(static_cast<std::uint32_t>(word.starts >> x & ~std::uint64_t{1}));
    const auto write = [&](std::uint32_t* row, std::uint64_t pixels) {
      store_labels(row + x, permuted_where(near, index, static_cast<std::uint32_t>(pixels >> x)),
                   count - x);
    };
    if constexpr (band == BandKind::pair) write(bottom, word.bottom);
    write(top, word.top);
  }
}

/// The words of a band, from the left.
template <BandKind band>
class BandReader {
 public:
  [[gnu::always_inline]] BandReader(const ConstBitPlaneView& image, Index number,
                                    const RunForest& runs)
      : bits_(image, number), ids_(runs.ids + runs.first[number] - 1) {}

  [[gnu::always_inline]] BandWord next() {
    const BandWord word = {bits_.starts(word_), bits_.top(word_), bits_.bottom(word_), ids_};
    ids_ += count_bits(word.starts);
    ++word_;
    return word;
  }

 private:
  BandBits<band> bits_;
  const Label* ids_;
  Index word_ = 0;
};

/// The words of a row with all its runs, whose ids are listed.
class RowReader {
 public:
  [[gnu::always_inline]] RowReader(const ConstBitPlaneView& image,
                                   const ConstBitPlaneView& background, Index y, const Label* ids)
      : bits_(image, background, y), ids_(ids - 1) {}

  [[gnu::always_inline]] BandWord next() {
    const BandWord word = {bits_.starts(word_), bits_.inside(word_), 0, ids_};
    ids_ += count_bits(word.starts);
    ++word_;
    return word;
  }
  /// Of the next row.
  [[nodiscard]] const Label* ids() const { return ids_ + 1; }

 private:
  RowBoundaries bits_;
  const Label* ids_;
  Index word_ = 0;
};

/// Writes the next `count` labels of each row, whole words except at the end of the row.
template <BandKind band, class Reader>
[[gnu::always_inline]] inline void paint_words(Reader& reader, std::uint32_t* top,
                                               std::uint32_t* bottom, Index count) {
  for (; count >= kWordBits; count -= kWordBits, top += kWordBits, bottom += kWordBits) {
    paint_word<band>(reader.next(), top, bottom, kWordBits);
  }
  if (count > 0) paint_word<band>(reader.next(), top, bottom, count);
}

/// Rows of a band, as memory; the same one twice where there is only one.
struct BandRows {
  std::uint32_t* top;
  std::uint32_t* bottom;
};

[[gnu::always_inline]] inline BandRows rows_of_band(BandKind band, const LabelView& labels,
                                                    Index number) {
  const Index y = number * rows_of(band);
  const Index last = y + rows_of(band) - 1;
  const auto row = [&](Index at) { return reinterpret_cast<std::uint32_t*>(labels.row(at)); };
  return {row(y), row(last < labels.height ? last : y)};
}

/// Label images of at least this many bytes are written with non-temporal stores: below, they cost
/// more than they save, as labels that are read next are still in the cache.
inline constexpr Index kNonTemporalLabelBytes = Index{4} << 20;

[[gnu::always_inline]] inline bool is_large(const LabelView& labels) {
  constexpr Index label_bytes = static_cast<Index>(sizeof(Label));
  return labels.width * labels.height * label_bytes >= kNonTemporalLabelBytes;
}

inline constexpr Index kLineLabels = static_cast<Index>(kAlignment / sizeof(Label));

/// Labels between the start of a cache line and these.
[[gnu::always_inline]] inline Index offset_in_line(const std::uint32_t* labels) {
  return static_cast<Index>(reinterpret_cast<std::uintptr_t>(labels) / sizeof(Label)) % kLineLabels;
}

/// Copies labels past the caches, from memory with the same offset in a line. Non-temporal stores
/// must fill lines; the ends take ordinary ones.
[[gnu::always_inline]] inline void stream_labels(std::uint32_t* to, const std::uint32_t* from,
                                                 Index count) {
  constexpr Index lanes = static_cast<Index>(Lanes32::size);
  const Index to_line = (kLineLabels - offset_in_line(to)) % kLineLabels;
  Index x = 0;
  for (; x < to_line && x < count; ++x) to[x] = from[x];
  for (; x + kLineLabels <= count; x += kLineLabels) {
    for (Index i = x; i < x + kLineLabels; i += lanes) {
      store_non_temporal(reinterpret_cast<std::uint8_t*>(to + i),
                         reinterpreted<ByteBatch>(Lanes32::load_aligned(from + i)));
    }
  }
  for (; x < count; ++x) to[x] = from[x];
}

/// Rows are painted to a buffer of this many labels first where whole cache lines are written.
inline constexpr Index kBufferedLabels = 2048;

template <BandKind band, class Reader>
[[gnu::always_inline]] inline void stream_band(Reader& reader, const BandRows& rows, Index width) {
  alignas(kAlignment) std::uint32_t buffers[2][kBufferedLabels + kLineLabels];
  for (Index x = 0; x < width; x += kBufferedLabels) {
    const Index count = width - x < kBufferedLabels ? width - x : kBufferedLabels;
    std::uint32_t* const top = buffers[0] + offset_in_line(rows.top + x);
    std::uint32_t* const bottom = buffers[1] + offset_in_line(rows.bottom + x);
    paint_words<band>(reader, top, bottom, count);
    stream_labels(rows.top + x, top, count);
    if (rows.top != rows.bottom) stream_labels(rows.bottom + x, bottom, count);
  }
}

template <BandKind band, class Reader>
[[gnu::always_inline]] inline void paint_band(Reader& reader, const LabelView& labels,
                                              Index number) {
  const BandRows rows = rows_of_band(band, labels, number);
  if (is_large(labels)) {
    stream_band<band>(reader, rows, labels.width);
  } else {
    paint_words<band>(reader, rows.top, rows.bottom, labels.width);
  }
}

template <BandKind band>
[[gnu::always_inline]] inline void paint_bands(const ConstBitPlaneView& image,
                                               const RunForest& runs, const LabelView& labels) {
  for (Index number = 0; number < bands_of(band, labels.height); ++number) {
    BandReader<band> reader(image, number, runs);
    paint_band<band>(reader, labels, number);
  }
  if (is_large(labels)) finish_non_temporal_stores();
}

template <BandKind band>
[[gnu::always_inline]] inline void paint_rows(const ConstBitPlaneView& image,
                                              const ConstBitPlaneView& background, const Label* ids,
                                              const LabelView& labels) {
  for (Index y = 0; y < labels.height; ++y) {
    RowReader reader(image, background, y, ids);
    paint_band<band>(reader, labels, y);
    ids = reader.ids();
  }
  if (is_large(labels)) finish_non_temporal_stores();
}

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
