#include "thinning/iterate.hpp"

#include <algorithm>

namespace thinbench {

TileActivity::TileActivity(Index height, Index row_elements, Index least_column) : height_(height) {
  constexpr Index most_columns = 64;
  const Index least_columns = std::max<Index>(1, row_elements / least_column);
  column_elements_ = least_column * ((least_columns + most_columns - 1) / most_columns);
  const Index columns = (least_columns * least_column + column_elements_ - 1) / column_elements_;
  all_columns_ = ~std::uint64_t{0} >> (most_columns - columns);
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
    const auto& step = history_[static_cast<std::size_t>(step_ - back) % kLongestCycle];
    for (std::size_t i = from; i <= to; ++i) recent |= step[i];
  }
  return (recent | recent << 1 | recent >> 1) & all_columns_;
}

std::span<const Band> TileActivity::begin_step(int cycle) {
  step_ = step_ == 0 ? kLongestCycle : step_ + 1;  // so that looking back stays above zero
  active_count_ = 0;
  for (std::size_t band = 0; band < active_.size(); ++band) {
    const std::uint64_t columns = active_columns(band, cycle);
    if (columns == 0) continue;
    const Index first = static_cast<Index>(band) * kRows;
    active_[active_count_++] = {first, std::min(first + kRows, height_), columns, column_elements_};
  }
  return {active_.data(), active_count_};
}

bool TileActivity::end_step() {
  auto& now = history_[static_cast<std::size_t>(step_) % kLongestCycle];
  std::fill(now.begin(), now.end(), 0);
  bool any = false;
  for (std::size_t place = 0; place < active_count_; ++place) {
    now[static_cast<std::size_t>(active_[place].first / kRows)] = changed_[place];
    any = any || changed_[place] != 0;
  }
  // As if everything had changed in the first step: the second, which fills the other buffer, must
  // visit all, too.
  if (step_ == kLongestCycle) std::fill(now.begin(), now.end(), all_columns_);
  return any;
}

namespace {

template <class T>
bool run_step(const Cycle<T>& cycle, Pass<T> pass, const ConstPlaneView<T>& source,
              const PlaneView<T>& target, TileActivity& activity, ThreadTeam& team) {
  const auto bands = activity.begin_step(static_cast<int>(cycle.passes.size()));
  team.for_ranges(static_cast<Index>(bands.size()), [&](Index first, Index last) {
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
      activity.set_changed(i, pass(cycle.model, source, target, bands[i]));
    }
  });
  return activity.end_step();
}

template <class T>
void copy_rows(const ConstPlaneView<T>& source, const PlaneView<T>& target) {
  for (Index y = 0; y < source.height; ++y) {
    std::copy_n(source.row(y), source.row_elements, target.row(y));
  }
}

}  // namespace

template <class T>
int iterate(const Cycle<T>& cycle, const ConstPlaneView<T>& source, const PlaneView<T>& target,
            const PlaneView<T>& scratch, TileActivity& activity, ThreadTeam& team) {
  activity.restart();
  ConstPlaneView<T> from = source;
  PlaneView<T> to = target;
  PlaneView<T> other = scratch;
  int cycles = 0;
  bool changed = true;
  while (changed && cycles < cycle.most_cycles) {
    changed = false;
    for (const Pass<T> pass : cycle.passes) {
      changed = run_step(cycle, pass, from, to, activity, team) || changed;
      from = to;
      std::swap(to, other);
    }
    ++cycles;
  }
  // After a cycle without change both buffers hold the result.
  if (changed && from.data != target.data) copy_rows(from, target);
  return cycles;
}

template int iterate(const Cycle<std::uint8_t>&, const ConstBytePlaneView&, const BytePlaneView&,
                     const BytePlaneView&, TileActivity&, ThreadTeam&);
template int iterate(const Cycle<std::uint64_t>&, const ConstBitPlaneView&, const BitPlaneView&,
                     const BitPlaneView&, TileActivity&, ThreadTeam&);

}  // namespace thinbench
