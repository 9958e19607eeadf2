// Iterates sub-iterations over double-buffered planes until nothing changes; skips inactive
// regions.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "core/planes.hpp"
#include "core/thread_team.hpp"
#include "engines/band.hpp"
#include "scan/bound_rule.hpp"
#include "thinbench/options.hpp"

namespace thinbench::detail {

/// Rows [first, last) of an image.
struct RowRange {
  Index first;
  Index last;
};

/// The rows that may change: all, or with Border::keep all but the first and last.
[[nodiscard]] RowRange changing_rows(Index height, Border border);

/// Tracks which cells of an image are active. A cell is the part of a band of kRows rows within one
/// of at most 64 columns. It is active, and must be computed, if it or one of its eight neighbours
/// changed in one of the last `lookback` sub-iterations.
///
/// This serves double-buffered planes, where a cell must be written once more after its last
/// change, into the other buffer, and where the cells of a band are computed together. The tile
/// engine updates tiles in place and lists them individually.
class BandActivity {
 public:
  static constexpr Index kRows = 16;

  /// Rows have `row_elements` elements, columns at least `min_column`.
  BandActivity(RowRange rows, Index row_elements, Index min_column);

  /// Marks all cells as active. Call before the first sub-iteration.
  void restart();
  /// Begins a sub-iteration and returns the bands with active cells, valid until the next call.
  /// `lookback` is at most kMaxSubIterations.
  std::span<const Band> begin_sub_iteration(int lookback);
  /// Records which columns of a band of the list changed. Thread-safe for different indices.
  void set_changed(std::size_t index, std::uint64_t columns) { changed_[index] = columns; }
  /// Ends the sub-iteration. True if any cell changed.
  bool end_sub_iteration();

  /// Runs one sub-iteration: `run(band)` computes the active columns of a band and returns those
  /// that changed; it may write the correct pixels of other columns, and writes no other rows.
  /// Threads share the bands. True if any cell changed.
  template <class Run>
  bool run_sub_iteration(int lookback, const ThreadTeam& team, const Run& run) {
    const auto bands = begin_sub_iteration(lookback);
    team.for_ranges(static_cast<Index>(bands.size()), [&](Index first, Index last) {
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
        set_changed(i, run(bands[i]));
      }
    });
    return end_sub_iteration();
  }

 private:
  [[nodiscard]] std::uint64_t active_columns(std::size_t band, int lookback) const;

  RowRange rows_;
  Index row_elements_;
  Index column_elements_;
  std::uint64_t all_columns_;
  std::int64_t sub_iteration_ = 0;
  std::size_t active_count_ = 0;
  std::vector<Band> active_;
  std::vector<std::uint64_t> changed_;
  std::array<std::vector<std::uint64_t>, kMaxSubIterations> history_;  // changed columns by band
};

template <class T>
void copy_rows(const ConstPlaneView<T>& source, const PlaneView<T>& target, RowRange rows) {
  for (Index y = rows.first; y < rows.last; ++y) {
    std::copy_n(source.row(y), source.row_elements, target.row(y));
  }
}

/// Copies the rows that do not change.
template <class T>
void copy_fixed_rows(const RowRange& changing, const ConstPlaneView<T>& source,
                     const PlaneView<T>& target) {
  copy_rows(source, target, {0, std::min(changing.first, source.height)});
  copy_rows(source, target, {changing.last, source.height});
}

/// How often to iterate, and where.
struct IterationPlan {
  int sub_iterations;
  int max_iterations;
  RowRange rows;  // that may change
};

/// The planes of iterate(), of equal sizes and without overlap.
template <class T>
struct IterationPlanes {
  ConstPlaneView<T> source;  // what the first sub-iteration reads
  PlaneView<T> target;       // the others alternate between these two; the result is in `target`
  PlaneView<T> scratch;
};

/// Iterates until an iteration changes nothing or the limit is reached; returns the number of
/// iterations, including the last. `run(sub, from, to, band)` applies a sub-iteration to a band,
/// see BandActivity::run_sub_iteration. `activity` must be constructed with `plan.rows`. Does not
/// allocate.
template <class T, class Run>
int iterate(const IterationPlan& plan, const IterationPlanes<T>& planes, BandActivity& activity,
            const ThreadTeam& team, const Run& run) {
  activity.restart();
  copy_fixed_rows(plan.rows, planes.source, planes.target);
  copy_fixed_rows(plan.rows, planes.source, planes.scratch);
  ConstPlaneView<T> from = planes.source;
  PlaneView<T> to = planes.target;
  PlaneView<T> other = planes.scratch;
  int iterations = 0;
  bool changed = true;
  while (changed && iterations < plan.max_iterations) {
    changed = false;
    for (int sub = 0; sub < plan.sub_iterations; ++sub) {
      changed = activity.run_sub_iteration(plan.sub_iterations, team, [&](const Band& band) {
        return run(sub, from, to, band);
      }) || changed;
      from = to;
      std::swap(to, other);
    }
    ++iterations;
  }
  // After an iteration without changes both buffers hold the result.
  if (changed && from.data != planes.target.data) {
    copy_rows(from, planes.target, {0, from.height});
  }
  return iterations;
}

/// A row with a 1 for every pixel that must not change: with Border::keep the first and the last
/// column, and for rules that add pixels the padding, which they would change. Empty if there is
/// none.
template <class T>
[[nodiscard]] Plane<T> fixed_pixels(Index width, Border border, bool adds_pixels) {
  if (width == 0 || (border != Border::keep && !adds_pixels)) return {};
  Plane<T> fixed(width, 1);
  T* const row = fixed.view().data;
  constexpr Index pixels = sizeof(T) == 1 ? 1 : kWordBits;
  const auto fix = [&](Index x) {
    row[x / pixels] = static_cast<T>(row[x / pixels] | T{1} << (x % pixels));
  };
  if (border == Border::keep) {
    fix(0);
    fix(width - 1);
  }
  const Index end = fixed.view().row_elements * pixels;
  for (Index x = width; adds_pixels && x < end; ++x) fix(x);
  return fixed;
}

}  // namespace thinbench::detail
