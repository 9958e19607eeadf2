// Iterates passes over double-buffered planes until nothing changes; skips inactive regions.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "image/thread_team.hpp"
#include "thinbench/options.hpp"
#include "thinning/engines/passes.hpp"

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
  /// Records the result of Pass for a band of the list. Thread-safe for different indices.
  void set_changed(std::size_t index, std::uint64_t columns) { changed_[index] = columns; }
  /// Ends the sub-iteration. True if any cell changed.
  bool end_sub_iteration();

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

/// The parameters of an iterated rule.
template <class T>
struct Repetition {
  const RuntimeRule* rule = nullptr;
  int max_iterations = kUnlimited;
  RowRange rows = {};        // that may change
  const T* fixed = nullptr;  // see Pass
};

/// Iterates a rule until an iteration changes nothing or `max_iterations` is reached; returns the
/// number of iterations, including the last. The first sub-iteration reads `source`, the others
/// alternate between `target` and `scratch`; the result is in `target`. All planes have equal sizes
/// and do not overlap. `activity` must be constructed with `repetition.rows`. Does not allocate.
template <class T>
int iterate(std::span<const Pass<T>> sub_iterations, const Repetition<T>& repetition,
            const ConstPlaneView<T>& source, const PlaneView<T>& target,
            const PlaneView<T>& scratch, BandActivity& activity, ThreadTeam& team);

/// The same for a rule with a single ChangePass. It rotates among three `buffers` besides `source`;
/// the result is in the first.
int iterate_changes(ChangePass sub_iteration, const Repetition<std::uint64_t>& repetition,
                    const ConstBitPlaneView& source, const std::array<BitPlaneView, 3>& buffers,
                    BandActivity& activity, ThreadTeam& team);

}  // namespace thinbench::detail
