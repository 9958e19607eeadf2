// Rows of runs with their ids: what label images are painted from, and regions summed from. Safe to
// include in ISA files.
#pragma once

#include "regions/run_bits.hpp"

namespace thinbench::detail {

/// Calls use(begin, end, id) for every run of a row, from the left.
template <BandKind band, class Use>
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

template <BandKind band>
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

/// Runs of both colours in a row: where they begin, for words from the left.
class RowBoundaries {
 public:
  [[gnu::always_inline]] RowBoundaries(const ConstBitPlaneView& image,
                                       const ConstBitPlaneView& background, Index y)
      : image_(image.row(y)),
        background_(background.row(y)),
        carry_(~image_[0] & 1) {}  // the first run begins at the border

  [[gnu::always_inline]] std::uint64_t inside(Index word) const {
    return image_[word] | background_[word];
  }
  [[gnu::always_inline]] std::uint64_t starts(Index word) {
    return (image_[word] ^ shifted(image_[word], carry_)) & inside(word);
  }

 private:
  const std::uint64_t* image_;
  const std::uint64_t* background_;
  std::uint64_t carry_;
};

/// The ids of the runs of a row, for words from the left.
template <BandKind band>
class RowIds {
 public:
  [[gnu::always_inline]] RowIds(const Objects& objects, const Background& background, Index y)
      : row_(objects.image.row(y)),
        pair_(objects.image, y / rows_of(band)),
        background_(background.image, y),
        objects_(objects.runs.ids + objects.runs.first[y / rows_of(band)] - 1),
        holes_(background.runs.ids + background.runs.first[y] - 1) {}

  [[gnu::always_inline]] RowRuns of_word(Index word) {
    const RowRuns runs = {row_[word], pair_.starts(word), background_.starts(word), objects_,
                          holes_};
    objects_ += count_bits(runs.foreground_starts);
    holes_ += count_bits(runs.background_starts);
    return runs;
  }

 private:
  const std::uint64_t* row_;
  BandBits<band> pair_;
  BandBits<BandKind::row> background_;
  const Label* objects_;
  const Label* holes_;
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

template <BandKind band>
[[gnu::always_inline]] inline Label* sum_all_runs(const Objects& objects,
                                                  const Background& background, Region* regions,
                                                  Label* ids) {
  const Index words = words_of(objects.image);
  for (Index y = 0; y < objects.image.height; ++y) {
    RowBoundaries boundaries(objects.image, background.image, y);
    RowIds<band> row(objects, background, y);
    Index begin = 0;
    Label west = 0, id = 0;
    for (Index word = 0; word < words; ++word) {
      const RowRuns runs = row.of_word(word);
      for (std::uint64_t left = boundaries.starts(word); left != 0; left &= left - 1) {
        const Index x = word * kWordBits + __builtin_ctzll(left);
        add_run_of(regions[id], begin, x, y, id > objects.count ? west : 0);
        begin = x;
        west = id;
        id = runs.id_at(left);
        *ids++ = id;
      }
    }
    add_run_of(regions[id], begin, objects.image.width, y, id > objects.count ? west : 0);
  }
  return ids;
}

template <BandKind band>
[[gnu::always_inline]] inline void paint_runs(const ConstBitPlaneView& image, const RunForest& runs,
                                              const LabelView& labels) {
  for (Index y = 0; y < image.height; ++y) {
    std::int32_t* const row = labels.row(y);
    for (Index x = 0; x < image.width; ++x) row[x] = 0;
    for_runs_of_row<band>(image, y, runs, [&](Index begin, Index end, Label id) {
      for (Index x = begin; x < end; ++x) row[x] = static_cast<std::int32_t>(id);
    });
  }
}

/// From the ids of all runs.
[[gnu::always_inline]] inline void paint_all_runs(const ConstBitPlaneView& image,
                                                  const ConstBitPlaneView& background,
                                                  const Label* ids, const LabelView& labels) {
  for (Index y = 0; y < labels.height; ++y) {
    RowBoundaries boundaries(image, background, y);
    std::int32_t* const row = labels.row(y);
    Index x = 0;
    for (Index word = 0; word < words_of(image); ++word) {
      for (std::uint64_t left = boundaries.starts(word); left != 0; left &= left - 1) {
        const Index end = word * kWordBits + __builtin_ctzll(left);
        for (; x < end; ++x) row[x] = static_cast<std::int32_t>(ids[-1]);
        ++ids;
      }
    }
    for (; x < labels.width; ++x) row[x] = static_cast<std::int32_t>(ids[-1]);
  }
}

}  // namespace thinbench::detail
