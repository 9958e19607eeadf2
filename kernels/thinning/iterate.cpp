#include "thinning/iterate.hpp"

#include <algorithm>

namespace thinbench {

BandActivity::BandActivity(Index height) {
  const auto bands = static_cast<std::size_t>((height + kRows - 1) / kRows);
  active_.resize(bands);
  last_change_.resize(bands);
  changed_.resize(bands);
}

void BandActivity::restart() {
  step_ = 0;
  // As if everything had changed in step 1: steps 1 and 2, which fill the two buffers, visit all.
  std::fill(last_change_.begin(), last_change_.end(), 1);
}

bool BandActivity::may_change(std::size_t band, int cycle) const {
  const std::size_t from = band == 0 ? 0 : band - 1;
  const std::size_t to = std::min(band + 1, last_change_.size() - 1);
  int latest = 0;
  for (std::size_t i = from; i <= to; ++i) latest = std::max(latest, last_change_[i]);
  return latest >= step_ - cycle;
}

std::span<const Index> BandActivity::begin_step(int cycle) {
  ++step_;
  active_count_ = 0;
  for (std::size_t band = 0; band < last_change_.size(); ++band) {
    if (!may_change(band, cycle)) continue;
    active_[static_cast<std::size_t>(active_count_++)] = static_cast<Index>(band);
  }
  return {active_.data(), static_cast<std::size_t>(active_count_)};
}

bool BandActivity::end_step() {
  bool any = false;
  for (Index i = 0; i < active_count_; ++i) {
    const auto band = static_cast<std::size_t>(active_[static_cast<std::size_t>(i)]);
    if (changed_[band] == 0) continue;
    last_change_[band] = step_;
    any = true;
  }
  return any;
}

namespace {

template <class T>
bool run_step(const Cycle<T>& cycle, Pass<T> pass, const ConstPlaneView<T>& source,
              const PlaneView<T>& target, BandActivity& activity, ThreadTeam& team) {
  const auto bands = activity.begin_step(static_cast<int>(cycle.passes.size()));
  team.for_ranges(static_cast<Index>(bands.size()), [&](Index first, Index last) {
    for (Index i = first; i < last; ++i) {
      const Index band = bands[static_cast<std::size_t>(i)];
      const Index top = band * BandActivity::kRows;
      const Index bottom = std::min(top + BandActivity::kRows, source.height);
      activity.set_changed(band, pass(cycle.model, source, target, top, bottom));
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
            const PlaneView<T>& scratch, BandActivity& activity, ThreadTeam& team) {
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
                     const BytePlaneView&, BandActivity&, ThreadTeam&);
template int iterate(const Cycle<std::uint64_t>&, const ConstBitPlaneView&, const BitPlaneView&,
                     const BitPlaneView&, BandActivity&, ThreadTeam&);

}  // namespace thinbench
