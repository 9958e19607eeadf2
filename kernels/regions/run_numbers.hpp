// Numbers objects in raster order of their first pixels. Safe to include in ISA files.
#pragma once

#include "regions/run_bits.hpp"

namespace thinbench::detail {

/// 1 for 0, else 0, of a number up to 2^31. GCC makes branches of comparisons, and what is a root
/// is unpredictable.
[[gnu::always_inline]] inline Label is_zero(Label number) {
  return ((number - 1) & ~number) >> 31;
}

/// `number` where `is` is 1, 0 where it is 0.
[[gnu::always_inline]] inline Label number_if(Label is, Label number) {
  return (0 - is) & number;
}

/// Numbers objects by the order of their first runs.
[[gnu::always_inline]] inline Label number_in_order(const RunForest& runs, Label begin, Label end,
                                                    Label objects) {
  for (Label run = begin; run < end; ++run) {
    const Label parent = runs.parents[run];
    const Label is_root = is_zero(parent ^ run);
    objects += is_root;
    runs.ids[run] = number_if(is_root, objects) | number_if(1 - is_root, runs.ids[parent]);
  }
  return objects;
}

/// In place of an id while a pair of rows is numbered: the run has a pixel in the first row.
inline constexpr Label kInFirstRow = Label{1} << 31;

/// Sets the ids of a pair's runs to kInFirstRow or 0; returns how many are not 0.
[[gnu::always_inline]] inline Label mark_first_row(const ConstBitPlaneView& image, Index number,
                                                   const RunForest& runs) {
  for (Label run = runs.first[number]; run < runs.first[number + 1]; ++run) runs.ids[run] = 0;
  BandBits<BandKind::pair> here(image, number);
  Follow in_run;
  Label before = runs.first[number] - 1;
  Label marked = 0;
  for (Index word = 0; word < words_of(image); ++word) {
    const std::uint64_t starts = here.starts(word);
    const std::uint64_t first = here.top(word) & ~in_run(here.top(word), starts);
    for (std::uint64_t left = first; left != 0; left &= left - 1) {
      runs.ids[before + count_bits(starts & (left ^ (left - 1)))] = kInFirstRow;
    }
    marked += count_bits(first);
    before += count_bits(starts);
  }
  return marked;
}

/// Numbers the object of a run in the first row whose root, in the same pair, is not.
[[gnu::always_inline]] inline Label number_late_root(const RunForest& runs, Label run, Label first,
                                                     Label objects) {
  while (run >= first && runs.parents[run] != run) run = runs.parents[run];
  if (run >= first && runs.ids[run] == 0) runs.ids[run] = ++objects;
  return objects;
}

/// Numbers the objects that begin in a pair of rows: first those that have a pixel in the first
/// row, then the others. `mark(number)` is mark_first_row().
template <class Mark>
[[gnu::always_inline]] inline Label number_pair(Index number, const RunForest& runs, Label objects,
                                                const Mark& mark_runs) {
  const auto& [parents, ids, firsts] = runs;
  const Label first = firsts[number];
  const Label end = firsts[number + 1];
  if (mark_runs(number) == end - first) {
    return number_in_order(runs, first, end, objects);
  }
  for (Label run = first; run < end; ++run) {
    const Label mark = ids[run];
    const Label in_first_row = mark >> 31;
    const Label is_new = is_zero(parents[run] ^ run) & in_first_row;
    const Label is_late = is_zero(ids[parents[run]]) & in_first_row;
    objects += is_new;
    ids[run] = mark | number_if(is_new, objects);
    if (__builtin_expect(is_late != 0, 0)) objects = number_late_root(runs, run, first, objects);
  }
  for (Label run = first; run < end; ++run) {
    const Label known = ids[parents[run]] & ~kInFirstRow;
    const Label is_new = is_zero(parents[run] ^ run) & is_zero(known);
    objects += is_new;
    ids[run] = known | number_if(is_new, objects);
  }
  return objects;
}

/// For runs that all belong to objects that begin before them.
[[gnu::always_inline]] inline void copy_ids(const RunForest& runs, Label begin, Label end) {
  for (Label run = begin; run < end; ++run) runs.ids[run] = runs.ids[runs.parents[run]];
}

[[gnu::always_inline]] inline Label count_roots(const Label* parents, Label begin, Label end) {
  Label roots = 0;
  for (Label run = begin; run < end; ++run) roots += parents[run] == run ? 1 : 0;
  return roots;
}

template <BandKind band, class Mark>
[[gnu::always_inline]] inline Label number_runs(const ConstBitPlaneView& image,
                                                const RunForest& runs, const Mark& mark_runs) {
  const Index bands = bands_of(band, image.height);
  if constexpr (band != BandKind::pair) return number_in_order(runs, 0, runs.first[bands], 0);
  Label objects = 0;
  for (Index number = 0; number < bands; ++number) {
    const Label begin = runs.first[number];
    const Label end = runs.first[number + 1];
    const Label roots = count_roots(runs.parents, begin, end);
    if (roots == 0) {
      copy_ids(runs, begin, end);
    } else if (roots == 1) {  // in any order
      objects = number_in_order(runs, begin, end, objects);
    } else {
      objects = number_pair(number, runs, objects, mark_runs);
    }
  }
  return objects;
}

}  // namespace thinbench::detail
