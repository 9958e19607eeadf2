// Iterations until nothing changes, over tiles, skipping those that cannot change any more.
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

/// The rows that may change.
[[nodiscard]] RowRange changing_rows(Index height, Border border);

/// Which tiles still change. Rows are grouped in bands of kRows, bands are cut into at most 64
/// columns; a tile can only change in a step if it or one of its eight neighbours changed in one of
/// the last `cycle` steps, a cycle being one application of every sub-iteration.
class TileActivity {
 public:
  static constexpr Index kRows = 16;

  /// Rows of `row_elements` elements, `min_column` of which are the narrowest column.
  TileActivity(RowRange rows, Index row_elements, Index min_column);

  /// Forgets everything: the next step is the first.
  void restart();
  /// Begins a step and lists the bands that have tiles to visit. `cycle` is at most
  /// kMaxSubIterations.
  std::span<const Band> begin_step(int cycle);
  /// What a pass returned for the band of this place in the list. Different places may be set from
  /// different threads.
  void set_changed(std::size_t place, std::uint64_t columns) { changed_[place] = columns; }
  /// Ends the step; true where any tile changed.
  bool end_step();

 private:
  [[nodiscard]] std::uint64_t active_columns(std::size_t band, int cycle) const;

  RowRange rows_;
  Index row_elements_;
  Index column_elements_;
  std::uint64_t all_columns_;
  int step_ = 0;
  std::size_t active_count_ = 0;
  std::vector<Band> active_;
  std::vector<std::uint64_t> changed_;
  std::array<std::vector<std::uint64_t>, kMaxSubIterations> history_;  // by step, then band
};

/// What a repetition depends on beside its passes.
template <class T>
struct Repetition {
  const RuntimeRule* rule = nullptr;
  int max_iterations = kUnlimited;
  RowRange rows = {};        // those that may change
  const T* fixed = nullptr;  // see Pass
};

/// Repeats a cycle of passes until it changes nothing or the limit is reached; returns how many
/// iterations ran, the last one included. Reads `source` once, then alternates between `target` and
/// `scratch`; the result is in `target`. All planes have one size and do not overlap; `activity`
/// was made for the rows of `repetition`. No allocation.
template <class T>
int iterate(std::span<const Pass<T>> cycle, const Repetition<T>& repetition,
            const ConstPlaneView<T>& source, const PlaneView<T>& target,
            const PlaneView<T>& scratch, TileActivity& activity, ThreadTeam& team);

/// The same for one pass that needs to know what changed. `buffers` are three planes besides
/// `source`; the result is in the first.
int iterate_changes(ChangePass pass, const Repetition<std::uint64_t>& repetition,
                    const ConstBitPlaneView& source, const std::array<BitPlaneView, 3>& buffers,
                    TileActivity& activity, ThreadTeam& team);

}  // namespace thinbench::detail
