#include "thinning/iteration/iterate.hpp"

#include <algorithm>
#include <utility>

namespace thinbench::detail {

RowRange changing_rows(Index height, Border border) {
  if (border == Border::background) return {0, height};
  return {1, std::max<Index>(1, height - 1)};
}

BandActivity::BandActivity(RowRange rows, Index row_elements, Index min_column)
    : rows_(rows), row_elements_(row_elements) {
  constexpr Index max_columns = 64;
  const Index narrow_columns = std::max<Index>(1, row_elements / min_column);
  column_elements_ = min_column * ((narrow_columns + max_columns - 1) / max_columns);
  const Index columns = (narrow_columns * min_column + column_elements_ - 1) / column_elements_;
  all_columns_ = row_elements == 0 ? 0 : ~std::uint64_t{0} >> (max_columns - columns);
  const auto bands = static_cast<std::size_t>((rows.last - rows.first + kRows - 1) / kRows);
  active_.resize(bands);
  changed_.resize(bands);
  for (auto& columns_by_band : history_) columns_by_band.resize(bands);
}

void BandActivity::restart() {
  sub_iteration_ = 0;
  for (auto& changed : history_) std::fill(changed.begin(), changed.end(), all_columns_);
}

std::uint64_t BandActivity::active_columns(std::size_t band, int lookback) const {
  const std::size_t from = band == 0 ? 0 : band - 1;
  const std::size_t to = std::min(band + 1, active_.size() - 1);
  std::uint64_t recent = 0;
  for (int back = 1; back <= lookback; ++back) {
    const auto& changed =
        history_[static_cast<std::size_t>(sub_iteration_ - back) % kMaxSubIterations];
    for (std::size_t i = from; i <= to; ++i) recent |= changed[i];
  }
  return (recent | recent << 1 | recent >> 1) & all_columns_;
}

std::span<const Band> BandActivity::begin_sub_iteration(int lookback) {
  // Starts at kMaxSubIterations so that indices into the history are never negative.
  sub_iteration_ = sub_iteration_ == 0 ? kMaxSubIterations : sub_iteration_ + 1;
  active_count_ = 0;
  for (std::size_t band = 0; band < active_.size(); ++band) {
    const std::uint64_t columns = active_columns(band, lookback);
    if (columns == 0) continue;
    const Index first = rows_.first + static_cast<Index>(band) * kRows;
    active_[active_count_++] = {first, std::min(first + kRows, rows_.last), columns,
                                column_elements_, row_elements_};
  }
  return {active_.data(), active_count_};
}

bool BandActivity::end_sub_iteration() {
  auto& now = history_[static_cast<std::size_t>(sub_iteration_) % kMaxSubIterations];
  std::fill(now.begin(), now.end(), 0);
  bool any = false;
  for (std::size_t i = 0; i < active_count_; ++i) {
    now[static_cast<std::size_t>((active_[i].first - rows_.first) / kRows)] = changed_[i];
    any = any || changed_[i] != 0;
  }
  // The second sub-iteration must write all cells, because its target is not initialised.
  if (sub_iteration_ == kMaxSubIterations) std::fill(now.begin(), now.end(), all_columns_);
  return any;
}

namespace {

/// Calls `body(band)` for every band with active cells. True if any of them changed.
template <class Body>
bool run_sub_iteration(int lookback, BandActivity& activity, ThreadTeam& team, const Body& body) {
  const auto bands = activity.begin_sub_iteration(lookback);
  team.for_ranges(static_cast<Index>(bands.size()), [&](Index first, Index last) {
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
      activity.set_changed(i, body(bands[i]));
    }
  });
  return activity.end_sub_iteration();
}

template <class T>
void copy_rows(const ConstPlaneView<T>& source, const PlaneView<T>& target, RowRange rows) {
  for (Index y = rows.first; y < rows.last; ++y) {
    std::copy_n(source.row(y), source.row_elements, target.row(y));
  }
}

template <class T>
void copy_fixed_rows(const RowRange& changing, const ConstPlaneView<T>& source,
                     const PlaneView<T>& target) {
  copy_rows(source, target, {0, std::min(changing.first, source.height)});
  copy_rows(source, target, {changing.last, source.height});
}

}  // namespace

template <class T>
int iterate(std::span<const Pass<T>> sub_iterations, const Repetition<T>& repetition,
            const ConstPlaneView<T>& source, const PlaneView<T>& target,
            const PlaneView<T>& scratch, BandActivity& activity, ThreadTeam& team) {
  activity.restart();
  for (const PlaneView<T>& plane : {target, scratch}) {
    copy_fixed_rows(repetition.rows, source, plane);
  }
  ConstPlaneView<T> from = source;
  PlaneView<T> to = target;
  PlaneView<T> other = scratch;
  const int lookback = static_cast<int>(sub_iterations.size());
  int iterations = 0;
  bool changed = true;
  while (changed && iterations < repetition.max_iterations) {
    changed = false;
    for (const Pass<T> pass : sub_iterations) {
      const auto run = [&](const Band& band) {
        return pass(repetition.rule, repetition.fixed, from, to, band);
      };
      changed = run_sub_iteration(lookback, activity, team, run) || changed;
      from = to;
      std::swap(to, other);
    }
    ++iterations;
  }
  // After an iteration without changes both buffers hold the result.
  if (changed && from.data != target.data) copy_rows(from, target, {0, from.height});
  return iterations;
}

int iterate_changes(ChangePass sub_iteration, const Repetition<std::uint64_t>& repetition,
                    const ConstBitPlaneView& source, const std::array<BitPlaneView, 3>& buffers,
                    BandActivity& activity, ThreadTeam& team) {
  // The target holds the image of three iterations ago: a cell may be skipped only after two
  // iterations without changes.
  constexpr int lookback = 2;
  activity.restart();
  const BitPlaneView& background = buffers[2];
  for (Index y = 0; y < background.height; ++y) {
    std::fill_n(background.row(y), background.row_elements, 0);
  }
  for (const BitPlaneView& plane : buffers) copy_fixed_rows(repetition.rows, source, plane);
  ConstBitPlaneView previous = background;
  ConstBitPlaneView current = source;
  int iterations = 0;
  for (bool changed = true; changed && iterations < repetition.max_iterations; ++iterations) {
    const BitPlaneView& next = buffers[static_cast<std::size_t>(iterations) % buffers.size()];
    changed = run_sub_iteration(lookback, activity, team, [&](const Band& band) {
      return sub_iteration(repetition.rule, repetition.fixed, previous, current, next, band);
    });
    previous = std::exchange(current, next);
  }
  if (current.data != buffers[0].data) copy_rows(current, buffers[0], {0, current.height});
  return iterations;
}

template int iterate(std::span<const Pass<std::uint8_t>>, const Repetition<std::uint8_t>&,
                     const ConstBytePlaneView&, const BytePlaneView&, const BytePlaneView&,
                     BandActivity&, ThreadTeam&);
template int iterate(std::span<const Pass<std::uint64_t>>, const Repetition<std::uint64_t>&,
                     const ConstBitPlaneView&, const BitPlaneView&, const BitPlaneView&,
                     BandActivity&, ThreadTeam&);

}  // namespace thinbench::detail
