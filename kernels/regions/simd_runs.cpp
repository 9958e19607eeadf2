// Sums runs in vector lanes, one run per lane, while the runs of adjacent rows match one to one;
// only runs near a change go through union-find. Compiled per ISA.
//
// Most rows of an image of parts repeat the runs of the row above with slightly moved ends. Cost of
// such a row, per vector of 4, 8 or 16 runs: 2 comparisons, 2 multiplications, 9 additions or
// minima, 8 loads and 5 stores, where bitpacked_runs takes about 30 instructions per run. Finding
// boundaries costs the same as there, except that AVX-512 skips eight words without boundaries at
// once, and with VBMI2 one compress lists all boundaries of a word.
#include <type_traits>

#include "core/exported.hpp"
#include "regions/run_rows.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

using KeyBatch = BatchOf<Key>;
constexpr Index kKeyLanes = static_cast<Index>(KeyBatch::size);
static_assert(kKeyLanes <= kKeyPadding);
static_assert(std::is_same_v<Key, IntBatch::value_type>);

/// As find_keys_of_word; with byte compress it writes whole vectors of keys.
///   bits       ..1....1.1     bytes  0 2 7 0 ..      keys  2 (64 word + 1 + byte) + (is an end)
/// Unused where a register holds less than a row.
[[gnu::always_inline, maybe_unused]] inline int store_keys(std::uint64_t bits, Index word,
                                                           Index before, Key* keys) {
  if constexpr (!kHasByteCompress) {
    return static_cast<int>(find_keys_of_word(bits, word, before, keys));
  } else {
    const ByteBatch bytes = set_bit_places(bits);
    // Every other boundary ends a run: the first one if an odd number of keys precedes it.
    const WordBatch is_end(before % 2 == 0 ? std::uint64_t{1} << 32 : 1);
    const IntBatch first =
        IntBatch(static_cast<Key>(2 * (word * kWordBits + 1))) + reinterpreted<IntBatch>(is_end);
    const auto store = [&](IntBatch sixteen, Index at) {
      ((sixteen << 1) + first).store_unaligned(keys + at);
    };
    const int count = __builtin_popcountll(bits);
    store(widened_quarter<0>(bytes), 0);
    if (__builtin_expect(count > 16, 0)) {
      store(widened_quarter<1>(bytes), 16);
      store(widened_quarter<2>(bytes), 32);
      store(widened_quarter<3>(bytes), 48);
    }
    return count;
  }
}

/// Writes the keys of a row and returns their number. Where a register holds eight words, words
/// without boundaries are skipped eight at a time.
[[gnu::always_inline]] inline Index find_keys_of_row(const std::uint64_t* row, Index words,
                                                     Key* keys) {
  if constexpr (!kRegisterHoldsRow) {
    return find_keys(row, words, keys);
  } else {
    Index count = 0;
    for (Index block = 0; block < words; block += kBlockWords) {
      const WordBatch here = WordBatch::load_unaligned(row + block);
      const WordBatch differing = here ^ WordTraits<WordBatch>::west(here, row + block);
      for (std::uint32_t left = nonzero_lanes(differing); left != 0; left &= left - 1) {
        const Index word = block + __builtin_ctz(left);
        count += store_keys(boundaries(row + word), word, count, keys + count);
      }
    }
    end_keys(keys, count);
    return count;
  }
}

/// Whether each of runs [0, count] touches its counterpart above and no other run.
[[gnu::always_inline]] inline bool all_match(const Key* above, const Key* here, Index count) {
  auto disjoint = KeyBatch(0) > KeyBatch(0);
  for (Index i = 0; i <= count; i += kKeyLanes) {
    const auto above_begin = KeyBatch::load_unaligned(above + i - 1);
    const auto above_end = KeyBatch::load_unaligned(above + i);
    const auto here_begin = KeyBatch::load_unaligned(here + i - 1);
    const auto here_end = KeyBatch::load_unaligned(here + i);
    disjoint = disjoint | (here_begin > above_end) | (above_begin > here_end);
  }
  return !simd::any(disjoint);
}

[[gnu::always_inline]] inline bool matches(const Key* above, const Key* here) {
  return here[-1] < above[0] && above[-1] < here[0];
}

/// Numbers of runs at the ends of two rows that match one to one and touch no others.
struct Matching {
  Index left;
  Index right;
};

[[gnu::always_inline]] inline Matching find_matching(const RunRow& above, const RunRow& here) {
  const Index max = above.count < here.count ? above.count : here.count;
  Index left = 0;
  while (left <= max && matches(above.keys + left, here.keys + left)) ++left;
  Index right = 0;
  while (right <= max &&
         matches(above.keys + above.count - right, here.keys + here.count - right)) {
    ++right;
  }
  // The first and the last run always match, as they are outside. The last matching one may also
  // touch the first that does not match.
  --left;
  --right;
  return {left, right < max + 1 - left ? right : max + 1 - left};
}

[[gnu::always_inline]] inline void clear_accumulators(const RunAccumulators& accumulators,
                                                      Index first, Index last) {
  for (Index i = first; i <= last; ++i) {
    accumulators.length[i] = 0;
    accumulators.squares[i] = 0;
    accumulators.rows[i] = 0;
    accumulators.min_begin[i] = kLastKey;
    accumulators.max_end[i] = kFirstKey;
  }
}

/// Wraps around like unsigned numbers: the keys of runs that reach the image border have no
/// meaning.
[[gnu::always_inline]] inline KeyBatch product(KeyBatch a, KeyBatch b) {
  return reinterpreted<KeyBatch>(reinterpreted<Lanes32>(a) * reinterpreted<Lanes32>(b));
}

[[gnu::always_inline]] inline void add_row(const RunAccumulators& accumulators, const Key* keys,
                                           Index count, Index rows_since_start) {
  const KeyBatch row(static_cast<Key>(rows_since_start));
  for (Index i = 0; i <= count; i += kKeyLanes) {
    const auto load = [i](const Key* from) { return KeyBatch::load_unaligned(from + i); };
    const KeyBatch begin_key = load(keys - 1);
    const KeyBatch end_key = load(keys);
    const KeyBatch begin = begin_key >> 1;
    const KeyBatch end = end_key >> 1;
    const KeyBatch length = end - begin;
    (load(accumulators.length) + length).store_unaligned(accumulators.length + i);
    (load(accumulators.squares) + product(length, begin + end))
        .store_unaligned(accumulators.squares + i);
    (load(accumulators.rows) + product(length, row)).store_unaligned(accumulators.rows + i);
    simd::min(load(accumulators.min_begin), begin_key).store_unaligned(accumulators.min_begin + i);
    simd::max(load(accumulators.max_end), end_key).store_unaligned(accumulators.max_end + i);
  }
}

/// Adds the accumulators of runs [first, last] over rows [start, end) to the runs' regions, except
/// those of runs that reach the image border (0 and `count`).
[[gnu::always_inline]] inline void flush_accumulators(RunLabelling& labelling, Index first,
                                                      Index last, Index start, Index end) {
  const RunAccumulators& accumulators = labelling.accumulators;
  const RunRow& row = labelling.above;
  if (first < 1) first = 1;
  if (last > row.count - 1) last = row.count - 1;
  for (Index i = first; i <= last; ++i) {
    Region& region = labelling.tables.of_colour[i % 2].regions[row.labels[i]];
    const auto unsigned_of = [](Key sum) { return std::int64_t{static_cast<std::uint32_t>(sum)}; };
    const std::int64_t length = unsigned_of(accumulators.length[i]);
    if (length == 0) continue;  // cleared for the next row
    region.area += length;
    region.sum_x += (unsigned_of(accumulators.squares[i]) - length) / 2 - length;
    region.sum_y += start * length + unsigned_of(accumulators.rows[i]);
    const auto left = static_cast<std::int32_t>(column_of(accumulators.min_begin[i]));
    const auto right = static_cast<std::int32_t>(column_of(accumulators.max_end[i]) - 1);
    if (left < region.left) region.left = left;
    if (right > region.right) region.right = right;
    region.bottom = static_cast<std::int32_t>(end - 1);
  }
}

template <class T>
[[gnu::always_inline]] inline void move_elements(T* elements, Index from, Index to, Index count) {
  __builtin_memmove(elements + to, elements + from, static_cast<std::size_t>(count) * sizeof(T));
}

/// Moves labels and accumulators of the last `count` runs to their new positions.
[[gnu::always_inline]] inline void move_runs(RunLabelling& labelling, Index from, Index to,
                                             Index count) {
  if (from == to) return;
  const RunAccumulators& accumulators = labelling.accumulators;
  for (Key* sums : {accumulators.length, accumulators.squares, accumulators.rows,
                    accumulators.min_begin, accumulators.max_end}) {
    move_elements(sums, from, to, count);
  }
  move_elements(labelling.above.labels, from, to, count);
}

/// Labels a row whose runs do not all match those above, by union-find for the runs between the
/// matching ends. Afterwards `above.labels` holds the new labels.
template <bool with_background>
[[gnu::always_inline]] inline void label_change(RunLabelling& labelling, Index start, Index y) {
  RunRow& above = labelling.above;
  RunRow& here = labelling.here;
  const Matching matching = find_matching(above, here);
  const Index first = matching.left;
  const Index last = here.count - matching.right;
  const Index last_above = above.count - matching.right;
  flush_accumulators(labelling, first, last_above, start, y);
  if (first > 0) here.labels[first - 1] = above.labels[first - 1];
  label_runs<with_background>(labelling.tables, above, first, here.keys, here.labels, first, last,
                              y);
  move_runs(labelling, last_above + 1, last + 1, matching.right);
  for (Index i = first; i <= last; ++i) above.labels[i] = here.labels[i];
  clear_accumulators(labelling.accumulators, first, last);
}

/// The number of rows that fit 32-bit accumulators: sums of squares stay below rows * (width +
/// 2)^2, sums of rows below rows^2 * width.
[[gnu::always_inline]] inline Index max_rows_per_flush(Index width) {
  constexpr Index max_rows = 1024;
  const Index rows = (Index{1} << 32) / ((width + 2) * (width + 2));
  return rows < max_rows ? rows : max_rows;
}

/// Whether contacts of runs are faster than union-find on a row whose runs do not match those
/// above.
template <bool with_background>
[[gnu::always_inline]] inline bool is_dense(Index boundaries, Index width) {
  constexpr Index pixels = with_background ? 6 : 7;
  return pixels * boundaries > width;
}

/// Counts a dense row, `other_rows` after the one before. False where the kernel should give up.
[[gnu::noinline]] bool has_patience(RunLabelling& labelling, Index other_rows) {
  const Index patience = labelling.patience + other_rows;
  labelling.patience = (patience < kPatience ? patience : kPatience) - 1;
  return labelling.patience >= 0;
}

/// Labels rows [first, last), at most max_rows_per_flush, or fewer if the tables have no room.
template <bool with_background>
Index label_block(const ConstBitPlaneView& image, Index first, Index last,
                  RunLabelling& labelling) {
  const Index words = words_with_boundaries(image.width);
  RunRow& above = labelling.above;
  RunRow& here = labelling.here;
  clear_accumulators(labelling.accumulators, 0, above.count);
  Index y = first;
  Index end = has_room(labelling.tables, image.width) ? last : first;
  Index after_dense = first;
  for (; y < end; ++y) {
    here.count = find_keys_of_row(image.row(y), words, here.keys);
    if (here.count != above.count || !all_match(above.keys, here.keys, here.count)) {
      label_change<with_background>(labelling, first, y);
      if (is_dense<with_background>(here.count, image.width)) {
        if (!has_patience(labelling, y - after_dense)) end = y + 1;
        after_dense = y + 1;
      }
      if (!has_room(labelling.tables, image.width)) end = y + 1;
    }
    add_row(labelling.accumulators, here.keys, here.count, y - first);
    Key* const keys = above.keys;
    above.keys = here.keys;
    above.count = here.count;
    here.keys = keys;
  }
  flush_accumulators(labelling, 0, above.count, first, y);
  return y;
}

/// Rows of narrower images have too few runs for lanes; wider ones do not fit 32-bit accumulators.
constexpr Index kMinWidth = 129;
constexpr Index kMaxWidth = 65534;

template <bool with_background>
Index label_rows(const ConstBitPlaneView& image, Index first, Index last, RunLabelling& labelling) {
  if (image.width < kMinWidth || image.width > kMaxWidth) {
    return label_rows_singly<with_background>(image, first, last, labelling);
  }
  const Index max_rows = max_rows_per_flush(image.width);
  Index y = first;
  while (y < last) {
    const Index end = y + max_rows < last ? y + max_rows : last;
    const Index reached = label_block<with_background>(image, y, end, labelling);
    if (reached < end) return reached;
    y = end;
  }
  return y;
}

}  // namespace

}  // namespace THINBENCH_ISA

template <>
constinit const RunEngine Exported<RunEngine, kThisIsa>::kKernels = {&label_rows<true>,
                                                                     &label_rows<false>};

}  // namespace thinbench::detail
