// Runs whose neighbours below match them one to one are summed up side by side in vector lanes, one
// run a lane; union-find sees only the runs round a change. Compiled for every level.
//
// Cost a row of n runs: 2 comparisons, 2 multiplications, 9 additions or minima, 8 loads and 5
// stores a vector of runs (4, 8 or 16), where bitpacked_runs spends about 30 instructions on every
// run. Finding boundaries costs the same as there below AVX-512, which passes over eight words
// without any at once; with VBMI2 one compress turns the 64 bits of a word into the list of its
// boundaries. Most rows of a picture of parts repeat the runs of the row above with slightly moved
// ends.
#include "dispatch/exported.hpp"
#include "regions/run_engine.hpp"
#include "regions/simd_keys.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

using KeyBatch = BatchOf<Key>;
constexpr Index kLanes = static_cast<Index>(KeyBatch::size);
static_assert(kLanes <= kKeyPadding);

/// Whether each of runs [0, count] touches its counterpart above and no other.
[[gnu::always_inline]] inline bool all_match(const Key* above, const Key* here, Index count) {
  auto apart = KeyBatch(0) > KeyBatch(0);
  for (Index i = 0; i <= count; i += kLanes) {
    const auto above_begin = KeyBatch::load_unaligned(above + i - 1);
    const auto above_end = KeyBatch::load_unaligned(above + i);
    const auto here_begin = KeyBatch::load_unaligned(here + i - 1);
    const auto here_end = KeyBatch::load_unaligned(here + i);
    apart = apart | (here_begin > above_end) | (above_begin > here_end);
  }
  return !xsimd::any(apart);
}

[[gnu::always_inline]] inline bool matches(const Key* above, const Key* here) {
  return here[-1] < above[0] && above[-1] < here[0];
}

/// Runs at either end of two rows that match one to one and touch nothing else.
struct Matching {
  Index left;
  Index right;
};

[[gnu::always_inline]] inline Matching find_matching(const RunRow& above, const RunRow& here) {
  const Index most = above.count < here.count ? above.count : here.count;
  Index left = 0;
  while (left <= most && matches(above.keys + left, here.keys + left)) ++left;
  Index right = 0;
  while (right <= most &&
         matches(above.keys + above.count - right, here.keys + here.count - right)) {
    ++right;
  }
  // The last run that was reached may touch the first that does not match.
  left = left > 0 ? left - 1 : 0;
  right = right > 0 ? right - 1 : 0;
  return {left, right < most + 1 - left ? right : most + 1 - left};
}

[[gnu::always_inline]] inline void start_slots(const RunSlots& slots, Index first, Index last) {
  for (Index i = first; i <= last; ++i) {
    slots.length[i] = 0;
    slots.squares[i] = 0;
    slots.rows[i] = 0;
    slots.least[i] = kLastKey;
    slots.largest[i] = kFirstKey;
  }
}

/// Sums wrap round like unsigned numbers: runs that reach the frame have keys without meaning.
[[gnu::always_inline]] inline KeyBatch product(KeyBatch a, KeyBatch b) {
  return reinterpreted<KeyBatch>(reinterpreted<Lanes32>(a) * reinterpreted<Lanes32>(b));
}

[[gnu::always_inline]] inline void add_row(const RunSlots& slots, const Key* keys, Index count,
                                           Index rows_since_start) {
  const KeyBatch row(static_cast<Key>(rows_since_start));
  for (Index i = 0; i <= count; i += kLanes) {
    const auto load = [i](const Key* from) { return KeyBatch::load_unaligned(from + i); };
    const KeyBatch begin_key = load(keys - 1);
    const KeyBatch end_key = load(keys);
    const KeyBatch begin = begin_key >> 1;
    const KeyBatch end = end_key >> 1;
    const KeyBatch length = end - begin;
    (load(slots.length) + length).store_unaligned(slots.length + i);
    (load(slots.squares) + product(length, begin + end)).store_unaligned(slots.squares + i);
    (load(slots.rows) + product(length, row)).store_unaligned(slots.rows + i);
    xsimd::min(load(slots.least), begin_key).store_unaligned(slots.least + i);
    xsimd::max(load(slots.largest), end_key).store_unaligned(slots.largest + i);
  }
}

/// Adds what the slots of runs [first, last] hold of rows [start, end) to the runs' regions. Runs
/// that reach the frame (0 and `count`) are left out.
[[gnu::always_inline]] inline void empty_slots(RunLabelling& labelling, Index first, Index last,
                                               Index start, Index end) {
  const RunSlots& slots = labelling.slots;
  const RunRow& row = labelling.above;
  if (first < 1) first = 1;
  if (last > row.count - 1) last = row.count - 1;
  for (Index i = first; i <= last; ++i) {
    Region& region = labelling.tables.of_colour[i % 2].regions[row.labels[i]];
    const auto unsigned_of = [](Key sum) { return std::int64_t{static_cast<std::uint32_t>(sum)}; };
    const std::int64_t length = unsigned_of(slots.length[i]);
    if (length == 0) continue;  // new in the row to come
    region.area += length;
    region.sum_x += (unsigned_of(slots.squares[i]) - length) / 2 - length;
    region.sum_y += start * length + unsigned_of(slots.rows[i]);
    const auto left = static_cast<std::int32_t>(column_of(slots.least[i]));
    const auto right = static_cast<std::int32_t>(column_of(slots.largest[i]) - 1);
    if (left < region.left) region.left = left;
    if (right > region.right) region.right = right;
    region.bottom = static_cast<std::int32_t>(end - 1);
  }
}

template <class T>
[[gnu::always_inline]] inline void move_elements(T* elements, Index from, Index to, Index count) {
  __builtin_memmove(elements + to, elements + from, static_cast<std::size_t>(count) * sizeof(T));
}

/// Gives the last runs of the row their new positions, labels and slots.
[[gnu::always_inline]] inline void move_runs(RunLabelling& labelling, Index from, Index to,
                                             Index count) {
  if (from == to) return;
  const RunSlots& slots = labelling.slots;
  for (Key* sums : {slots.length, slots.squares, slots.rows, slots.least, slots.largest}) {
    move_elements(sums, from, to, count);
  }
  move_elements(labelling.above.labels, from, to, count);
}

/// Labels the row `here`, whose runs do not all match those above: union-find for the runs between
/// the matching ends. `above` keeps its label memory, which then holds the new labels.
template <bool with_background>
[[gnu::always_inline]] inline void label_change(RunLabelling& labelling, Index start, Index y) {
  RunRow& above = labelling.above;
  RunRow& here = labelling.here;
  const Matching matching = find_matching(above, here);
  const Index first = matching.left;
  const Index last = here.count - matching.right;
  const Index last_above = above.count - matching.right;
  empty_slots(labelling, first, last_above, start, y);
  if (first > 0) here.labels[first - 1] = above.labels[first - 1];
  label_runs<with_background>(labelling.tables, above, first, here.keys, here.labels, first, last,
                              y);
  move_runs(labelling, last_above + 1, last + 1, matching.right);
  for (Index i = first; i <= last; ++i) above.labels[i] = here.labels[i];
  start_slots(labelling.slots, first, last);
}

/// Rows that the slots can sum up before 32 bits are too few: sums of squares stay below
/// rows (width + 2)^2, sums of rows below rows^2 width.
[[gnu::always_inline]] inline Index rows_between_emptyings(Index width) {
  constexpr Index most = 1024;
  const Index rows = (Index{1} << 32) / ((width + 2) * (width + 2));
  return rows < most ? rows : most;
}

/// Labels rows [first, last), at most rows_between_emptyings.
template <bool with_background>
Index label_block(const ConstBitPlaneView& image, Index first, Index last,
                  RunLabelling& labelling) {
  const Index words = words_with_boundaries(image.width);
  RunRow& above = labelling.above;
  RunRow& here = labelling.here;
  start_slots(labelling.slots, 0, above.count);
  Index y = first;
  for (; y < last && has_room(labelling.tables, image.width); ++y) {
    here.count = find_keys_of_row(image.row(y), words, here.keys);
    if (here.count != above.count || !all_match(above.keys, here.keys, here.count)) {
      label_change<with_background>(labelling, first, y);
    }
    add_row(labelling.slots, here.keys, here.count, y - first);
    Key* const keys = above.keys;
    above.keys = here.keys;
    above.count = here.count;
    here.keys = keys;
  }
  empty_slots(labelling, 0, above.count, first, y);
  return y;
}

template <bool with_background>
Index label_rows(const ConstBitPlaneView& image, Index first, Index last, RunLabelling& labelling) {
  const Index most = rows_between_emptyings(image.width);
  Index y = first;
  while (y < last) {
    const Index end = y + most < last ? y + most : last;
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
