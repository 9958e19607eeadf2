// Iterations until nothing changes, over tiles, without those that cannot change any more.
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

/// Tracks which tiles still change. Tiles are bands of kRows rows, cut into at most 64 columns. A
/// tile can change in a sub-iteration only if it or one of its eight neighbours changed in one of
/// the last `length` sub-iterations, `length` being that of an iteration.
///
/// Unlike the lists of the tile engine, this selects parts of double-buffered planes: a tile has to
/// be written once more after its last change, into the other buffer, and a band's tiles are
/// visited together. The tile engine updates its tiles in place and lists them one by one.
class TileActivity {
 public:
  static constexpr Index kRows = 16;

  /// Rows have `row_elements` elements; columns have at least `min_column`.
  TileActivity(RowRange rows, Index row_elements, Index min_column);

  /// Before the first sub-iteration.
  void restart();
  /// Begins a sub-iteration and returns the bands with tiles to visit. `length` is at most
  /// kMaxSubIterations.
  std::span<const Band> begin_step(int length);
  /// The result of Pass for a band, by its index in the list. Threads may set different bands.
  void set_changed(std::size_t index, std::uint64_t columns) { changed_[index] = columns; }
  /// Ends the sub-iteration; true where any tile changed.
  bool end_step();

 private:
  [[nodiscard]] std::uint64_t active_columns(std::size_t band, int length) const;

  RowRange rows_;
  Index row_elements_;
  Index column_elements_;
  std::uint64_t all_columns_;
  int sub_iteration_ = 0;
  std::size_t active_count_ = 0;
  std::vector<Band> active_;
  std::vector<std::uint64_t> changed_;
  std::array<std::vector<std::uint64_t>, kMaxSubIterations> history_;  // columns by band
};

/// The parameters of a repetition.
template <class T>
struct Repetition {
  const RuntimeRule* rule = nullptr;
  int max_iterations = kUnlimited;
  RowRange rows = {};        // that may change
  const T* fixed = nullptr;  // see Pass
};

/// Repeats the sub-iterations of a rule until an iteration changes nothing or the limit is reached;
/// returns the number of iterations, the last included. Reads `source` once, then alternates
/// between `target` and `scratch`; the result is in `target`. All planes have one size and do not
/// overlap; `activity` was made for the rows of `repetition`. No allocation.
template <class T>
int iterate(std::span<const Pass<T>> sub_iterations, const Repetition<T>& repetition,
            const ConstPlaneView<T>& source, const PlaneView<T>& target,
            const PlaneView<T>& scratch, TileActivity& activity, ThreadTeam& team);

/// The same for one sub-iteration that reads what the last one changed. `buffers` are three planes
/// besides `source`; the result is in the first.
int iterate_changes(ChangePass sub_iteration, const Repetition<std::uint64_t>& repetition,
                    const ConstBitPlaneView& source, const std::array<BitPlaneView, 3>& buffers,
                    TileActivity& activity, ThreadTeam& team);

}  // namespace thinbench::detail
