#include "thinning/iteration/iterate.hpp"

#include <algorithm>
#include <utility>

namespace thinbench::detail {

TileActivity::TileActivity(Index height, Index row_elements, Index least_column)
    : height_(height), row_elements_(row_elements) {
  constexpr Index most_columns = 64;
  const Index least_columns = std::max<Index>(1, row_elements / least_column);
  column_elements_ = least_column * ((least_columns + most_columns - 1) / most_columns);
  const Index columns = (least_columns * least_column + column_elements_ - 1) / column_elements_;
  all_columns_ = row_elements == 0 ? 0 : ~std::uint64_t{0} >> (most_columns - columns);
  const auto bands = static_cast<std::size_t>((height + kRows - 1) / kRows);
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
    const Index first = static_cast<Index>(band) * kRows;
    active_[active_count_++] = {first, std::min(first + kRows, height_), columns, column_elements_,
                                row_elements_};
  }
  return {active_.data(), active_count_};
}

bool TileActivity::end_step() {
  auto& now = history_[static_cast<std::size_t>(step_) % kMaxSubIterations];
  std::fill(now.begin(), now.end(), 0);
  bool any = false;
  for (std::size_t place = 0; place < active_count_; ++place) {
    now[static_cast<std::size_t>(active_[place].first / kRows)] = changed_[place];
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

/// Copies one pixel; true where it was another.
bool copy_pixel(const std::uint8_t* source, std::uint8_t* target, Index x) {
  return std::exchange(target[x], source[x]) != source[x];
}

bool copy_pixel(const std::uint64_t* source, std::uint64_t* target, Index x) {
  const std::uint64_t bit = std::uint64_t{1} << (x % kWordBits);
  const std::uint64_t different = (source[x / kWordBits] ^ target[x / kWordBits]) & bit;
  target[x / kWordBits] ^= different;
  return different != 0;
}

/// Gives the outermost pixels of a band their old values again; true where a pass had changed one.
template <class T>
bool restore_border(const ConstPlaneView<T>& source, const PlaneView<T>& target, const Band& band) {
  bool restored = false;
  for (Index y = band.first; y < band.last; ++y) {
    const T* from = source.row(y);
    if (y == 0 || y == source.height - 1) {
      restored = restored || !std::equal(from, from + source.row_elements, target.row(y));
      copy_row(source, target, y);
    } else {
      restored = copy_pixel(from, target.row(y), 0) || restored;
      restored = copy_pixel(from, target.row(y), source.width - 1) || restored;
    }
  }
  return restored;
}

/// Those of `columns` in which the two differ.
template <class T>
std::uint64_t differing_columns(const ConstPlaneView<T>& source, const PlaneView<T>& target,
                                Band band, std::uint64_t columns) {
  std::uint64_t differing = 0;
  for (; columns != 0; columns &= columns - 1) {
    band.columns = columns & (~columns + 1);
    differing |= for_each_run(band, [&](Index y, Index from, Index to) {
      return !std::equal(source.row(y) + from, source.row(y) + to, target.row(y) + from);
    });
  }
  return differing;
}

/// What really changed in a band whose pass knows nothing of the border that is to be kept: engines
/// stay free of it, and tiles are looked at twice only where a pixel on the frame had changed.
template <class T>
std::uint64_t with_border_kept(const ConstPlaneView<T>& source, const PlaneView<T>& target,
                               const Band& band, std::uint64_t changed) {
  if (!restore_border(source, target, band)) return changed;
  return differing_columns(source, target, band, changed);
}

}  // namespace

template <class T>
int iterate(std::span<const Pass<T>> cycle, const Conditions& conditions,
            const ConstPlaneView<T>& source, const PlaneView<T>& target,
            const PlaneView<T>& scratch, TileActivity& activity, ThreadTeam& team) {
  activity.restart();
  ConstPlaneView<T> from = source;
  PlaneView<T> to = target;
  PlaneView<T> other = scratch;
  int cycles = 0;
  bool changed = true;
  while (changed && cycles < conditions.max_iterations) {
    changed = false;
    for (const Pass<T> pass : cycle) {
      const auto band_pass = [&](const Band& band) {
        const std::uint64_t columns = pass(conditions.model, from, to, band);
        if (conditions.border == Border::background) return columns;
        return with_border_kept(from, to, band, columns);
      };
      changed = run_step(static_cast<int>(cycle.size()), activity, team, band_pass) || changed;
      from = to;
      std::swap(to, other);
    }
    ++cycles;
  }
  // After a cycle without change both buffers hold the result.
  if (changed && from.data != target.data) copy_rows(from, target);
  return cycles;
}

int iterate_changes(ChangePass pass, const Conditions& conditions, const ConstBitPlaneView& source,
                    const std::array<BitPlaneView, 3>& buffers, TileActivity& activity,
                    ThreadTeam& team) {
  // A step writes what is three steps old: a tile must have been quiet for two to be passed over.
  constexpr int quiet_steps = 2;
  activity.restart();
  clear_rows(buffers[2]);
  ConstBitPlaneView previous = buffers[2];
  ConstBitPlaneView current = source;
  int passes = 0;
  for (bool changed = true; changed && passes < conditions.max_iterations; ++passes) {
    const BitPlaneView& next = buffers[static_cast<std::size_t>(passes) % buffers.size()];
    changed = run_step(quiet_steps, activity, team, [&](const Band& band) {
      const std::uint64_t columns = pass(conditions.model, previous, current, next, band);
      if (conditions.border == Border::background) return columns;
      return with_border_kept(current, next, band, columns);
    });
    previous = std::exchange(current, next);
  }
  if (current.data != buffers[0].data) copy_rows(current, buffers[0]);
  return passes;
}

template int iterate(std::span<const Pass<std::uint8_t>>, const Conditions&,
                     const ConstBytePlaneView&, const BytePlaneView&, const BytePlaneView&,
                     TileActivity&, ThreadTeam&);
template int iterate(std::span<const Pass<std::uint64_t>>, const Conditions&,
                     const ConstBitPlaneView&, const BitPlaneView&, const BitPlaneView&,
                     TileActivity&, ThreadTeam&);

}  // namespace thinbench::detail
