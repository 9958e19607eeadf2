// Runs whose neighbours below match them one to one are summed up side by side in vector lanes, one
// run a lane; union-find sees only the runs round a change. Compiled for every level.
//
// Cost a row of n runs: 2 comparisons, 2 multiplications, 9 additions or minima, 8 loads and 5
// stores a vector of runs (4, 8 or 16), where bitpacked_runs spends about 30 instructions on every
// run. Finding boundaries costs the same as there, except with VBMI2: one compress turns the 64
// bits of a word into the list of its boundaries, 11 instructions a word without any branch.
// Most rows of a picture of parts repeat the runs of the row above with slightly moved ends.
#include "core/batch.hpp"
#include "holes/run_engine.hpp"

namespace thinbench {
namespace {

using KeyBatch = xsimd::batch<Key, Architecture>;
constexpr Index kLanes = static_cast<Index>(KeyBatch::size);
static_assert(kLanes <= kKeyPadding);

#ifdef __AVX512VBMI2__
/// Writes the keys of a word's boundaries, whole vectors of them, and returns how many there are.
///   bits       ..1....1.1     bytes  0 2 7 0 ..      keys  2 (64 word + 1 + byte) + (is an end)
[[gnu::always_inline]] inline int store_keys(std::uint64_t bits, Index word, Index before,
                                             Key* keys) {
  const __m512i numbers = _mm512_set_epi8(
      63, 62, 61, 60, 59, 58, 57, 56, 55, 54, 53, 52, 51, 50, 49, 48, 47, 46, 45, 44, 43, 42, 41,
      40, 39, 38, 37, 36, 35, 34, 33, 32, 31, 30, 29, 28, 27, 26, 25, 24, 23, 22, 21, 20, 19, 18,
      17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
  const __m512i bytes = _mm512_maskz_compress_epi8(bits, numbers);
  // Every other boundary is an end, the first one where an odd number came before.
  const __m512i is_end = _mm512_set1_epi64(before % 2 == 0 ? std::int64_t{1} << 32 : 1);
  const __m512i first =
      _mm512_add_epi32(_mm512_set1_epi32(static_cast<Key>(2 * (word * kWordBits + 1))), is_end);
  const auto store = [&](__m128i sixteen, Index at) {
    const __m512i wide = _mm512_cvtepu8_epi32(sixteen);
    _mm512_storeu_si512(keys + at, _mm512_add_epi32(_mm512_slli_epi32(wide, 1), first));
  };
  const int count = __builtin_popcountll(bits);
  store(_mm512_castsi512_si128(bytes), 0);
  if (__builtin_expect(count > 16, 0)) {
    store(_mm512_extracti32x4_epi32(bytes, 1), 16);
    store(_mm512_extracti32x4_epi32(bytes, 2), 32);
    store(_mm512_extracti32x4_epi32(bytes, 3), 48);
  }
  return count;
}
#elif defined(__AVX512F__)
[[gnu::always_inline]] inline int store_keys(std::uint64_t bits, Index word, Index before,
                                             Key* keys) {
  return static_cast<int>(find_keys_of_word(bits, word, before, keys));
}
#endif

#ifdef __AVX512F__
/// One bit for each of the eight words that has boundaries.
[[gnu::always_inline]] inline unsigned words_that_count(const std::uint64_t* words) {
  const WordBatch here = WordBatch::load_unaligned(words);
  const WordBatch differing = here ^ WordTraits<WordBatch>::west(here, words);
  return _mm512_test_epi64_mask(differing, differing);
}

/// Writes the keys of a row and returns how many there are; words without boundaries are passed
/// over, eight at a time.
[[gnu::always_inline]] inline Index find_keys_of_row(const std::uint64_t* row, Index words,
                                                     Key* keys) {
  Index count = 0;
  for (Index block = 0; block < words; block += kBlockWords) {
    for (unsigned left = words_that_count(row + block); left != 0; left &= left - 1) {
      const Index word = block + __builtin_ctz(left);
      count += store_keys(boundaries(row + word), word, count, keys + count);
    }
  }
  end_keys(keys, count);
  return count;
}
#else
[[gnu::always_inline]] inline Index find_keys_of_row(const std::uint64_t* row, Index words,
                                                     Key* keys) {
  return find_keys(row, words, keys);
}
#endif

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
    (load(slots.squares) + length * (begin + end)).store_unaligned(slots.squares + i);
    (load(slots.rows) + length * row).store_unaligned(slots.rows + i);
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

template <>
constinit const RunEngine RunEngines<kThisIsa>::kSimd = {&label_rows<true>, &label_rows<false>};

}  // namespace thinbench
