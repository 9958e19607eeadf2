// Runs as bits: a run is the bit where it begins, and its number is the count of such bits up to
// it. There are no lists of runs. Safe to include in ISA files.
//
// Two rows that are OR-ed are one row of runs: "Bit-Merge-Run-Scan", W. Lee and others, Fast
// Run-Based Connected Components Labeling for Bitonal Images, ICIEV 2021. Here contacts between
// bands are bits, too, one for each two runs that touch.
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
template <BandKind band>
class BandBits {
 public:
  [[gnu::always_inline]] BandBits(const ConstBitPlaneView& image, Index number)
      : row_(image.row(number * rows_of(band))), stride_(image.stride) {}

  /// The first row.
  [[gnu::always_inline]] std::uint64_t top(Index word) const { return row_[word]; }
  /// The last row.
  [[gnu::always_inline]] std::uint64_t bottom(Index word) const {
    return band == BandKind::pair ? row_[stride_ + word] : top(word);
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
template <BandKind band>
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
/// at it. With corners, and for pairs of rows, at the bit or one before it.
template <BandKind band>
class Contacts {
 public:
  [[gnu::always_inline]] std::uint64_t operator()(std::uint64_t upper, std::uint64_t lower) {
    if constexpr (band == BandKind::row) return upper & lower;
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
template <BandKind band>
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
template <BandKind band, class UniteWithAbove>
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
[[gnu::always_inline]] inline void unite_background(const Background& background,
                                                    const UniteWithAbove& unite_with_above) {
  const auto& [image, runs, ends] = background;
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
    if (!(y == 0 && ends.top) && !(y == last && ends.bottom)) continue;
    for (Label run = first[y]; run < first[y + 1]; ++run) unite(runs.parents, run, 0);
  }
}

}  // namespace thinbench::detail
