// Runs as bits: a run is the bit where it begins, and its number is the count of such bits up to
// it. There are no lists of runs. Safe to include in ISA files.
//
// Two rows that are OR-ed are one row of runs, from "Bit-Merge-Run-Scan", W. Lee, F. Bolelli,
// S. Allegretti, C. Grana: Fast Run-Based Connected Components Labeling for Bitonal Images,
// ICIEV 2021. Here contacts between bands are bits, too, one for each two runs that touch.
#pragma once

#include "regions/label_kernels.hpp"

namespace thinbench::detail {

[[gnu::always_inline]] inline Label count_bits(std::uint64_t bits) {
  return static_cast<Label>(__builtin_popcountll(bits));
}

/// Bit i is set where bit i - 1 is; bit 0 comes from `carry`, which becomes the highest bit.
[[gnu::always_inline]] inline std::uint64_t shifted(std::uint64_t bits, std::uint64_t& carry) {
  const std::uint64_t result = bits << 1 | carry;
  carry = bits >> 63;
  return result;
}

/// Marks all bits that follow a seed, up to the next stop: bits after it that are reached without
/// passing one. An addition carries seeds through the bits between stops. Words from low to high.
class Follow {
 public:
  [[gnu::always_inline]] std::uint64_t operator()(std::uint64_t seeds, std::uint64_t stops) {
    const std::uint64_t open = ~stops;
    const std::uint64_t entries = shifted(seeds, seed_) & open;
    unsigned long long sum = 0;
    const bool first = __builtin_uaddll_overflow(open, entries, &sum);
    const bool second = __builtin_uaddll_overflow(sum, carry_, &sum);
    // A carry from the word before sets bit 0 as a seed would.
    const std::uint64_t reached = ((sum ^ open) | entries | carry_) & open;
    carry_ = first || second ? 1 : 0;
    return reached;
  }

 private:
  std::uint64_t seed_ = 0;
  std::uint64_t carry_ = 0;
};

[[gnu::always_inline]] inline Index words_of(const ConstBitPlaneView& image) {
  return (image.width + kWordBits - 1) / kWordBits;
}

/// A band as bits. Words from 0 to words_of(image), the last of which has no pixels.
template <Band band>
class BandBits {
 public:
  [[gnu::always_inline]] BandBits(const ConstBitPlaneView& image, Index number)
      : row_(image.row(number * rows_of(band))), stride_(image.stride) {}

  /// The first row.
  [[gnu::always_inline]] std::uint64_t top(Index word) const { return row_[word]; }
  /// The last row.
  [[gnu::always_inline]] std::uint64_t bottom(Index word) const {
    return band == Band::pair ? row_[stride_ + word] : top(word);
  }
  [[gnu::always_inline]] std::uint64_t merged(Index word) const { return top(word) | bottom(word); }
  /// Where runs begin; for words from the left.
  [[gnu::always_inline]] std::uint64_t starts(Index word) {
    const std::uint64_t bits = merged(word);
    return bits & ~shifted(bits, carry_);
  }

 private:
  const std::uint64_t* row_;
  Index stride_;
  std::uint64_t carry_ = 0;
};

/// Counts the runs from number `runs` on.
template <Band band>
[[gnu::always_inline]] inline void count_runs(const ConstBitPlaneView& image, Label runs,
                                              Label* first) {
  const Index words = words_of(image);
  const Index bands = bands_of(band, image.height);
  for (Index number = 0; number < bands; ++number) {
    first[number] = runs;
    BandBits<band> here(image, number);
    for (Index word = 0; word < words; ++word) runs += count_bits(here.starts(word));
  }
  first[bands] = runs;
}

/// Contacts of a row with the row below: both runs have begun at or before the bit, and they touch
/// at it. For pairs of rows, at the bit or one before it.
template <Band band>
class Contacts {
 public:
  [[gnu::always_inline]] std::uint64_t operator()(std::uint64_t upper, std::uint64_t lower) {
    if constexpr (band != Band::pair) return upper & lower;
    const std::uint64_t lower_west = shifted(lower, lower_);
    const std::uint64_t upper_west = shifted(upper, upper_);
    return (upper & (lower | lower_west)) | (lower & upper_west);
  }

 private:
  std::uint64_t lower_ = 0;
  std::uint64_t upper_ = 0;
};

/// Where runs begin in a word of a band and of the band above, and the last runs before it.
struct TwoBands {
  std::uint64_t upper;
  std::uint64_t lower;
  Label before_above;
  Label before_here;
};

/// Joins runs at contacts: at those that are the first of a run it copies a parent, and only later
/// ones need the forest.
[[gnu::always_inline]] inline void join_runs(Label* parents, const TwoBands& word,
                                             std::uint64_t first, std::uint64_t later) {
  const auto above = [&](std::uint64_t contacts) {
    return parents[word.before_above + count_bits(word.upper & (contacts ^ (contacts - 1)))];
  };
  const auto here = [&](std::uint64_t contacts) -> Label& {
    return parents[word.before_here + count_bits(word.lower & (contacts ^ (contacts - 1)))];
  };
  for (; first != 0; first &= first - 1) here(first) = above(first);
  for (; __builtin_expect(later != 0, 0); later &= later - 1) {
    unite(parents, here(later), above(later));
  }
}

/// Unites the runs of a band with those of the band above.
template <Band band>
[[gnu::always_inline]] inline void unite_band(const ConstBitPlaneView& image, Index number,
                                              const RunForest& runs) {
  BandBits<band> above(image, number - 1);
  BandBits<band> here(image, number);
  Contacts<band> contacts;
  Follow in_both, in_lower;
  Label before_above = runs.first[number - 1] - 1;  // the last run before the word
  Label before_here = runs.first[number] - 1;
  const Index words = words_of(image);
  for (Index word = 0; word < words; ++word) {
    const std::uint64_t upper = above.starts(word);
    const std::uint64_t lower = here.starts(word);
    const std::uint64_t all = contacts(above.bottom(word), here.top(word));
    const std::uint64_t distinct = all & ~in_both(all, upper | lower);
    const std::uint64_t later = distinct & in_lower(distinct, lower);
    join_runs(runs.parents, {upper, lower, before_above, before_here}, distinct & ~later, later);
    before_above += count_bits(upper);
    before_here += count_bits(lower);
  }
}

[[gnu::always_inline]] inline void separate_runs(const RunForest& runs, Label count) {
  for (Label run = 0; run < count; ++run) runs.parents[run] = run;
}

/// `unite_with_above(number)` is unite_band().
template <Band band, class UniteWithAbove>
[[gnu::always_inline]] inline void unite_runs(const ConstBitPlaneView& image, const RunForest& runs,
                                              const UniteWithAbove& unite_with_above) {
  const Index bands = bands_of(band, image.height);
  separate_runs(runs, runs.first[bands]);
  for (Index number = 1; number < bands; ++number) {
    const bool none_above = runs.first[number - 1] == runs.first[number];
    const bool none_here = runs.first[number] == runs.first[number + 1];
    if (!none_above && !none_here) unite_with_above(number);
  }
}

[[gnu::always_inline]] inline void write_background(const ConstBitPlaneView& image,
                                                    const BitPlaneView& background) {
  const Index whole = image.width / kWordBits;
  const std::uint64_t rest = (std::uint64_t{1} << image.width % kWordBits) - 1;
  for (Index y = 0; y < image.height; ++y) {
    const std::uint64_t* const from = image.row(y);
    std::uint64_t* const to = background.row(y);
    for (Index word = 0; word < whole; ++word) to[word] = ~from[word];
    if (rest != 0) to[whole] = ~from[whole] & rest;
  }
}

/// Background that reaches the image border belongs to run 0.
template <class UniteWithAbove>
[[gnu::always_inline]] inline void unite_background(const ConstBitPlaneView& image,
                                                    const RunForest& runs,
                                                    const UniteWithAbove& unite_with_above) {
  const Label* const first = runs.first;
  const Index last = image.height - 1;
  separate_runs(runs, first[image.height]);
  const Index right = image.width - 1;
  for (Index y = 0; y <= last; ++y) {
    if (first[y] == first[y + 1]) continue;
    if (y > 0 && first[y - 1] != first[y]) unite_with_above(y);
    const std::uint64_t* const row = image.row(y);
    if ((row[0] & 1) != 0) unite(runs.parents, first[y], 0);
    if ((row[right / kWordBits] >> right % kWordBits & 1) != 0) {
      unite(runs.parents, first[y + 1] - 1, 0);
    }
    if (y > 0 && y < last) continue;
    for (Label run = first[y]; run < first[y + 1]; ++run) unite(runs.parents, run, 0);
  }
}

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
  BandBits<Band::pair> here(image, number);
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
/// row, then the others.
[[gnu::always_inline]] inline Label number_pair(const ConstBitPlaneView& image, Index number,
                                                const RunForest& runs, Label objects) {
  const auto& [parents, ids, firsts] = runs;
  const Label first = firsts[number];
  const Label end = firsts[number + 1];
  if (mark_first_row(image, number, runs) == end - first) {
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

[[gnu::always_inline]] inline bool has_root(const Label* parents, Label begin, Label end) {
  bool found = false;
  for (Label run = begin; run < end; ++run) found |= parents[run] == run;
  return found;
}

template <Band band>
[[gnu::always_inline]] inline Label number_runs(const ConstBitPlaneView& image,
                                                const RunForest& runs) {
  const Index bands = bands_of(band, image.height);
  if constexpr (band != Band::pair) return number_in_order(runs, 0, runs.first[bands], 0);
  Label objects = 0;
  for (Index number = 0; number < bands; ++number) {
    const Label begin = runs.first[number];
    const Label end = runs.first[number + 1];
    if (has_root(runs.parents, begin, end)) {
      objects = number_pair(image, number, runs, objects);
    } else {
      copy_ids(runs, begin, end);
    }
  }
  return objects;
}

/// Calls use(begin, end, id) for every run of a row, from the left.
template <Band band, class Use>
[[gnu::always_inline]] inline void for_runs_of_row(const ConstBitPlaneView& image, Index y,
                                                   const RunForest& runs, const Use& use) {
  const Index number = y / rows_of(band);
  BandBits<band> here(image, number);
  const bool is_top = y % rows_of(band) == 0;
  const Label* const ids = runs.ids + runs.first[number] - 1;
  const Index words = words_of(image);
  Label before = 0;
  std::uint64_t carry = 0;
  Index begin = 0;
  Label id = 0;
  for (Index word = 0; word <= words; ++word) {  // the last run may end at the first bit after
    const std::uint64_t starts = here.starts(word);
    const std::uint64_t row = is_top ? here.top(word) : here.bottom(word);
    for (std::uint64_t left = row ^ shifted(row, carry); left != 0; left &= left - 1) {
      const std::uint64_t upto = left ^ (left - 1);
      const Index x = word * kWordBits + __builtin_ctzll(left);
      if ((row & left & -left) != 0) {
        begin = x;
        id = ids[before + count_bits(starts & upto)];
      } else {
        use(begin, x, id);
      }
    }
    before += count_bits(starts);
  }
}

template <Band band>
[[gnu::always_inline]] inline void sum_runs(const ConstBitPlaneView& image, const RunForest& runs,
                                            Region* objects) {
  for (Index y = 0; y < image.height; ++y) {
    for_runs_of_row<band>(image, y, runs, [&](Index begin, Index end, Label id) {
      Region& region = objects[id - 1];
      if (region.area == 0) region.top = static_cast<std::int32_t>(y);
      add_run(region, begin, end, y);
    });
  }
}

/// The bits of a word of one row, and how to find the ids of its runs of both colours.
struct RowRuns {
  std::uint64_t foreground;
  std::uint64_t background;
  std::uint64_t foreground_starts;
  std::uint64_t background_starts;
  const Label* objects;  // ids of the last runs before the word
  const Label* holes;

  /// Of the run that begins at the lowest bit of `at`.
  [[gnu::always_inline]] Label id_at(std::uint64_t at) const {
    const std::uint64_t upto = at ^ (at - 1);
    return (foreground & at & -at) != 0 ? objects[count_bits(foreground_starts & upto)]
                                        : holes[count_bits(background_starts & upto)];
  }
};

/// The words of a row, from the left.
template <Band band>
class RowReader {
 public:
  [[gnu::always_inline]] RowReader(const Objects& objects, const Background& background, Index y)
      : row_(objects.image.row(y)),
        pair_(objects.image, y / rows_of(band)),
        background_(background.image, y),
        objects_(objects.runs.ids + objects.runs.first[y / rows_of(band)] - 1),
        holes_(background.runs.ids + background.runs.first[y] - 1) {}

  [[gnu::always_inline]] RowRuns next() {
    const RowRuns runs = {row_[word_],
                          background_.top(word_),
                          pair_.starts(word_),
                          background_.starts(word_),
                          objects_,
                          holes_};
    objects_ += count_bits(runs.foreground_starts);
    holes_ += count_bits(runs.background_starts);
    ++word_;
    return runs;
  }

 private:
  const std::uint64_t* row_;
  BandBits<band> pair_;
  BandBits<Band::row> background_;
  const Label* objects_;
  const Label* holes_;
  Index word_ = 0;
};

/// The pixel to the west of a hole's first pixel belongs to the enclosing object, whose id is
/// `west`.
[[gnu::always_inline]] inline void add_run_of(Region& region, Index begin, Index end, Index y,
                                              Label west) {
  if (region.area == 0) {
    region.top = static_cast<std::int32_t>(y);
    region.enclosing_object = west;
  }
  add_run(region, begin, end, y);
}

template <Band band>
[[gnu::always_inline]] inline void sum_all_runs(const Objects& objects,
                                                const Background& background, Region* regions) {
  const Index words = words_of(objects.image);
  for (Index y = 0; y < objects.image.height; ++y) {
    RowReader<band> reader(objects, background, y);
    std::uint64_t carry = ~objects.image.row(y)[0] & 1;  // the first run begins at the border
    Index begin = 0;
    Label west = 0, id = 0;
    for (Index word = 0; word < words; ++word) {
      const RowRuns runs = reader.next();
      const std::uint64_t inside = runs.foreground | runs.background;
      std::uint64_t left = (runs.foreground ^ shifted(runs.foreground, carry)) & inside;
      for (; left != 0; left &= left - 1) {
        const Index x = word * kWordBits + __builtin_ctzll(left);
        add_run_of(regions[id], begin, x, y, id > objects.count ? west : 0);
        begin = x;
        west = id;
        id = runs.id_at(left);
      }
    }
    add_run_of(regions[id], begin, objects.image.width, y, id > objects.count ? west : 0);
  }
}

/// Writes the ids of runs to row y, others are left as they are.
template <Band band>
[[gnu::always_inline]] inline void paint_runs_of_row(const ConstBitPlaneView& image, Index y,
                                                     const RunForest& runs, std::int32_t* row) {
  for_runs_of_row<band>(image, y, runs, [&](Index begin, Index end, Label id) {
    for (Index x = begin; x < end; ++x) row[x] = static_cast<std::int32_t>(id);
  });
}

template <Band band>
[[gnu::always_inline]] inline void paint_runs(const ConstBitPlaneView& image, const RunForest& runs,
                                              const LabelView& labels) {
  for (Index y = 0; y < image.height; ++y) {
    std::int32_t* const row = labels.row(y);
    for (Index x = 0; x < image.width; ++x) row[x] = 0;
    paint_runs_of_row<band>(image, y, runs, row);
  }
}

[[gnu::always_inline]] inline void paint_all_runs(const Objects& objects,
                                                  const Background& background,
                                                  const LabelView& labels) {
  for (Index y = 0; y < labels.height; ++y) {
    paint_runs_of_row<Band::pair>(objects.image, y, objects.runs, labels.row(y));
    paint_runs_of_row<Band::row>(background.image, y, background.runs, labels.row(y));
  }
}

}  // namespace thinbench::detail
