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
bool run_step(Pass<T> pass, int cycle, const ConstPlaneView<T>& source, const PlaneView<T>& target,
              BandActivity& activity, ThreadTeam& team) {
  const std::span<const Index> bands = activity.begin_step(cycle);
  team.for_ranges(static_cast<Index>(bands.size()), [&](Index first, Index last) {
    for (Index i = first; i < last; ++i) {
      const Index band = bands[static_cast<std::size_t>(i)];
      const Index top = band * BandActivity::kRows;
      const Index bottom = std::min(top + BandActivity::kRows, source.height);
      activity.set_changed(band, pass(source, target, top, bottom));
    }
  });
  return activity.end_step();
}

}  // namespace

template <class T>
int iterate(std::span<const Pass<T>> cycle, const ConstPlaneView<T>& source,
            const PlaneView<T>& target, const PlaneView<T>& scratch, BandActivity& activity,
            ThreadTeam& team) {
  const int length = static_cast<int>(cycle.size());
  activity.restart();
  ConstPlaneView<T> from = source;
  PlaneView<T> to = target;
  PlaneView<T> other = scratch;
  int cycles = 0;
  for (bool changed = true; changed; ++cycles) {
    changed = false;
    for (const Pass<T> pass : cycle) {
      changed = run_step(pass, length, from, to, activity, team) || changed;
      from = to;
      std::swap(to, other);
    }
  }
  return cycles;
}

template int iterate(std::span<const Pass<std::uint8_t>>, const ConstBytePlaneView&,
                     const BytePlaneView&, const BytePlaneView&, BandActivity&, ThreadTeam&);
template int iterate(std::span<const Pass<std::uint64_t>>, const ConstBitPlaneView&,
                     const BitPlaneView&, const BitPlaneView&, BandActivity&, ThreadTeam&);

}  // namespace thinbench
