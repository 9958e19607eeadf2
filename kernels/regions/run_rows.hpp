// Rows as runs of equal pixels, and which runs of adjacent rows touch. Safe to include in ISA
// files.
//
// A row is represented by its boundaries, as sorted keys: 2 (x + 1) where a foreground run begins
// at x, and 2 (x + 1) + 1 where one ends before x. Run i lies between keys[i - 1] and keys[i]; even
// runs are background, odd runs foreground; the first and the last run reach the image border. Due
// to the low bit, one comparison serves 8-connected foreground and 4-connected background: runs of
// the same colour in adjacent rows touch if and only if each begins before the other ends, by
// strict comparison of keys. The compared keys are never equal.
//
//   x         0 1 2 3 4 5 6 7          keys  6 11 14 17  (foreground in [2, 4) and [6, 7))
//   pixels    . . # # . . # .          runs  0 background, 1 foreground, 2 background, ...
#pragma once

#include "regions/label_table.hpp"
#include "thinbench/isa.hpp"

namespace thinbench::detail {

using Key = std::int32_t;

/// Before the first boundary of a row and after its last one.
inline constexpr Key kFirstKey = 0;
inline constexpr Key kLastKey = INT32_MAX;

/// This many kLastKey follow the keys of a row, and as many elements after them may be overwritten.
/// Kernels that only call label_runs() write kReadPadding of them.
inline constexpr Index kKeyPadding = 16;

struct RunRow {
  Key* keys = nullptr;  // keys[-1] is kFirstKey
  Label* labels = nullptr;
  Index count = 0;  // number of keys; there are count + 1 runs
};

/// The column where a run begins (its first key) or one past its end (its last key).
[[gnu::always_inline]] inline std::int64_t column_of(Key key) {
  return (key >> 1) - 1;
}

/// Words of a row that can hold boundaries. A run that ends with the row has one past the last
/// pixel.
[[gnu::always_inline]] inline Index words_with_boundaries(Index width) {
  return width / kWordBits + 1;
}

/// Bits of pixels that differ from their west neighbour.
[[gnu::always_inline]] inline std::uint64_t boundaries(const std::uint64_t* word) {
  return word[0] ^ (word[0] << 1 | word[-1] >> 63);
}

template <Index padding = kKeyPadding>
[[gnu::always_inline]] inline void end_keys(Key* keys, Index count) {
  for (Index i = 0; i < padding; ++i) keys[count + i] = kLastKey;
}

/// Writes the keys of a word's boundaries and returns their number; `before` is the number of keys
/// before them in the row.
[[gnu::always_inline]] inline Index find_keys_of_word(std::uint64_t bits, Index word, Index before,
                                                      Key* keys) {
  const auto first = static_cast<Key>(2 * (word * kWordBits + 1));
  Index count = 0;
  for (; bits != 0; bits &= bits - 1, ++count) {
    keys[count] = first + 2 * __builtin_ctzll(bits) + static_cast<Key>((before + count) & 1);
  }
  return count;
}

/// Writes the keys of a row and returns their number.
template <Index padding = kKeyPadding>
[[gnu::always_inline]] inline Index find_keys(const std::uint64_t* row, Index words, Key* keys) {
  Index count = 0;
  for (Index word = 0; word < words; ++word) {
    count += find_keys_of_word(boundaries(row + word), word, count, keys + count);
  }
  end_keys<padding>(keys, count);
  return count;
}

/// As many label_runs() reads after the keys of a row.
inline constexpr Index kReadPadding = 2;

/// Labels runs [first, last] of row y, given the labelled row above, whose runs before
/// `first_above` touch none of them. `labels[first - 1]` must be set, as the enclosing object of a
/// hole that begins with run `first`. Background runs get label 0 unless `with_background`.
template <bool with_background>
[[gnu::always_inline]] inline void label_runs(LabelTables& tables, const RunRow& above,
                                              Index first_above, const Key* keys, Label* labels,
                                              Index first, Index last, Index y) {
  Index next = first_above;
  for (Index i = first; i <= last; ++i) {
    const bool background = i % 2 == 0;
    if (!with_background && background) {
      labels[i] = 0;
      continue;
    }
    while (above.keys[next] < keys[i - 1]) ++next;
    Index touching = next + (i + next) % 2;
    LabelTable& table = tables.of_colour[i % 2];
    if (!(above.keys[touching - 1] < keys[i])) {
      labels[i] = new_label(table, y, background ? labels[i - 1] : 0);
      continue;
    }
    Label label = above.labels[touching];
    for (touching += 2; above.keys[touching - 1] < keys[i]; touching += 2) {
      label = unite(table.parents, label, above.labels[touching]);
    }
    labels[i] = label;
  }
}

/// Adds the runs of row y to their regions, except the first and the last.
[[gnu::always_inline]] inline void add_runs(LabelTables& tables, const RunRow& row, Index y) {
  for (Index i = 1; i < row.count; ++i) {
    add_run(tables.of_colour[i % 2].regions[row.labels[i]], column_of(row.keys[i - 1]),
            column_of(row.keys[i]), y);
  }
}

/// Sums of each run, used while the runs of adjacent rows match one to one. They are unsigned; the
/// kernel adds them to the regions before any reaches 2^32.
struct RunAccumulators {
  Key* length = nullptr;     // sum of lengths
  Key* squares = nullptr;    // sum of end^2 - begin^2, columns counted from 1
  Key* rows = nullptr;       // sum of length * (row - first row)
  Key* min_begin = nullptr;  // minimum of first keys
  Key* max_end = nullptr;    // maximum of last keys
};

/// As many more dense rows than others a kernel takes before it gives up.
inline constexpr Index kPatience = 32;

/// The working data of a kernel, in the caller's memory. Rows of runs and accumulators have room
/// for any row plus 2 * kKeyPadding.
struct RunLabelling {
  LabelTables tables;
  RunRow above;  // the last row that was labelled and summed
  RunRow here;   // memory for the next one
  RunAccumulators accumulators;
  /// A kernel may count here the rows on which contacts of runs are faster, and give up below 0.
  Index patience = kPatience;
};

/// Labels and sums rows [first, last), given `above`. Returns `last`, or the first row not
/// processed because the tables need room for (width + 1) / 2 more labels, or patience is at an
/// end.
using LabelRows = Index (*)(const ConstBitPlaneView& image, Index first, Index last,
                            RunLabelling& labelling);

/// `holes` labels background runs too, `objects` only foreground. Compiled per ISA.
struct RunEngine {
  LabelRows holes;
  LabelRows objects;
};

/// LabelRows without accumulators.
template <bool with_background>
[[gnu::always_inline]] inline Index label_rows_singly(const ConstBitPlaneView& image, Index first,
                                                      Index last, RunLabelling& labelling) {
  const Index words = words_with_boundaries(image.width);
  RunRow above = labelling.above;
  RunRow here = labelling.here;
  Index y = first;
  for (; y < last && has_room(labelling.tables, image.width); ++y) {
    here.count = find_keys<kReadPadding>(image.row(y), words, here.keys);
    label_runs<with_background>(labelling.tables, above, 0, here.keys, here.labels, 0, here.count,
                                y);
    add_runs(labelling.tables, here, y);
    const RunRow labelled = here;
    here = above;
    above = labelled;
  }
  labelling.above = above;
  labelling.here = here;
  return y;
}

}  // namespace thinbench::detail
