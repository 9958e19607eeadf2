#include "thinning/iteration/iterate.hpp"

#include <algorithm>
#include <utility>

namespace thinbench::detail {

RowRange changing_rows(Index height, Border border) {
  if (border == Border::background) return {0, height};
  return {1, std::max<Index>(1, height - 1)};
}

TileActivity::TileActivity(RowRange rows, Index row_elements, Index min_column)
    : rows_(rows), row_elements_(row_elements) {
  constexpr Index max_columns = 64;
  const Index narrowest = std::max<Index>(1, row_elements / min_column);
  column_elements_ = min_column * ((narrowest + max_columns - 1) / max_columns);
  const Index columns = (narrowest * min_column + column_elements_ - 1) / column_elements_;
  all_columns_ = row_elements == 0 ? 0 : ~std::uint64_t{0} >> (max_columns - columns);
  const auto bands = static_cast<std::size_t>((rows.last - rows.first + kRows - 1) / kRows);
  active_.resize(bands);
  changed_.resize(bands);
  for (auto& step : history_) step.resize(bands);
}

void TileActivity::restart() {
  step_ = 0;
  for (auto& step : history_) std::fill(step.begin(), step.end(), all_columns_);
}

std::uint64_t TileActivity::active_columns(std::size_t band, int cycle) const {
  const std::size_t from = band == 0 ? 0 : band - 1;
  const std::size_t to = std::min(band + 1, active_.size() - 1);
  std::uint64_t recent = 0;
  for (int back = 1; back <= cycle; ++back) {
    const auto& step = history_[static_cast<std::size_t>(step_ - back) % kMaxSubIterations];
    for (std::size_t i = from; i <= to; ++i) recent |= step[i];
  }
  return (recent | recent << 1 | recent >> 1) & all_columns_;
}

std::span<const Band> TileActivity::begin_step(int cycle) {
  step_ = step_ == 0 ? kMaxSubIterations : step_ + 1;  // so that looking back stays above zero
  active_count_ = 0;
  for (std::size_t band = 0; band < active_.size(); ++band) {
    const std::uint64_t columns = active_columns(band, cycle);
    if (columns == 0) continue;
    const Index first = rows_.first + static_cast<Index>(band) * kRows;
    active_[active_count_++] = {first, std::min(first + kRows, rows_.last), columns,
                                column_elements_, row_elements_};
  }
  return {active_.data(), active_count_};
}

bool TileActivity::end_step() {
  auto& now = history_[static_cast<std::size_t>(step_) % kMaxSubIterations];
  std::fill(now.begin(), now.end(), 0);
  bool any = false;
  for (std::size_t place = 0; place < active_count_; ++place) {
    now[static_cast<std::size_t>((active_[place].first - rows_.first) / kRows)] = changed_[place];
    any = any || changed_[place] != 0;
  }
  // As if everything had changed in the first step: the second, which fills the other buffer, must
  // visit all, too.
  if (step_ == kMaxSubIterations) std::fill(now.begin(), now.end(), all_columns_);
  return any;
}

namespace {

/// Calls `pass(band)` for every band that may change in a cycle of `length` steps. True where one
/// did.
template <class BandPass>
bool run_step(int length, TileActivity& activity, ThreadTeam& team, const BandPass& pass) {
  const auto bands = activity.begin_step(length);
  team.for_ranges(static_cast<Index>(bands.size()), [&](Index first, Index last) {
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
      activity.set_changed(i, pass(bands[i]));
    }
  });
  return activity.end_step();
}

template <class T>
void copy_row(const ConstPlaneView<T>& source, const PlaneView<T>& target, Index y) {
  std::copy_n(source.row(y), source.row_elements, target.row(y));
}

template <class T>
void copy_rows(const ConstPlaneView<T>& source, const PlaneView<T>& target) {
  for (Index y = 0; y < source.height; ++y) copy_row(source, target, y);
}

void clear_rows(const BitPlaneView& plane) {
  for (Index y = 0; y < plane.height; ++y) std::fill_n(plane.row(y), plane.row_elements, 0);
}

/// Copies the rows that never change.
template <class T>
void copy_fixed_rows(const RowRange& changing, const ConstPlaneView<T>& source,
                     const PlaneView<T>& target) {
  for (Index y = 0; y < std::min(changing.first, source.height); ++y) copy_row(source, target, y);
  for (Index y = changing.last; y < source.height; ++y) copy_row(source, target, y);
}

}  // namespace

template <class T>
int iterate(std::span<const Pass<T>> cycle, const Repetition<T>& repetition,
            const ConstPlaneView<T>& source, const PlaneView<T>& target,
            const PlaneView<T>& scratch, TileActivity& activity, ThreadTeam& team) {
  activity.restart();
  for (const PlaneView<T>& plane : {target, scratch}) {
    copy_fixed_rows(repetition.rows, source, plane);
  }
  ConstPlaneView<T> from = source;
  PlaneView<T> to = target;
  PlaneView<T> other = scratch;
  int iterations = 0;
  bool changed = true;
  while (changed && iterations < repetition.max_iterations) {
    changed = false;
    for (const Pass<T> pass : cycle) {
      const auto band_pass = [&](const Band& band) {
        return pass(repetition.rule, repetition.fixed, from, to, band);
      };
      changed = run_step(static_cast<int>(cycle.size()), activity, team, band_pass) || changed;
      from = to;
      std::swap(to, other);
    }
    ++iterations;
  }
  // After an iteration without change both buffers hold the result.
  if (changed && from.data != target.data) copy_rows(from, target);
  return iterations;
}

int iterate_changes(ChangePass pass, const Repetition<std::uint64_t>& repetition,
                    const ConstBitPlaneView& source, const std::array<BitPlaneView, 3>& buffers,
                    TileActivity& activity, ThreadTeam& team) {
  // A step writes what is three steps old: a tile must have been quiet for two to be skipped.
  constexpr int quiet_steps = 2;
  activity.restart();
  clear_rows(buffers[2]);
  for (const BitPlaneView& plane : buffers) copy_fixed_rows(repetition.rows, source, plane);
  ConstBitPlaneView previous = buffers[2];
  ConstBitPlaneView current = source;
  int iterations = 0;
  for (bool changed = true; changed && iterations < repetition.max_iterations; ++iterations) {
    const BitPlaneView& next = buffers[static_cast<std::size_t>(iterations) % buffers.size()];
    changed = run_step(quiet_steps, activity, team, [&](const Band& band) {
      return pass(repetition.rule, repetition.fixed, previous, current, next, band);
    });
    previous = std::exchange(current, next);
  }
  if (current.data != buffers[0].data) copy_rows(current, buffers[0]);
  return iterations;
}

template int iterate(std::span<const Pass<std::uint8_t>>, const Repetition<std::uint8_t>&,
                     const ConstBytePlaneView&, const BytePlaneView&, const BytePlaneView&,
                     TileActivity&, ThreadTeam&);
template int iterate(std::span<const Pass<std::uint64_t>>, const Repetition<std::uint64_t>&,
                     const ConstBitPlaneView&, const BitPlaneView&, const BitPlaneView&,
                     TileActivity&, ThreadTeam&);

}  // namespace thinbench::detail
