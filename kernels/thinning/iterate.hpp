// Passes until nothing changes, over bands of rows, skipping bands that cannot change any more.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/thread_team.hpp"
#include "thinning/passes.hpp"

namespace thinbench {

/// Which bands of rows still change. Rows are grouped in bands of kRows; a band can only change in
/// a step if it or a neighbour changed in one of the last `cycle` steps, a cycle being one
/// application of every sub-iteration.
class BandActivity {
 public:
  static constexpr Index kRows = 16;

  explicit BandActivity(Index height);

  /// Forgets everything: the next step is the first.
  void restart();
  /// Begins a step and lists the bands that it must visit.
  std::span<const Index> begin_step(int cycle);
  void set_changed(Index band, bool changed) { changed_[static_cast<std::size_t>(band)] = changed; }
  /// Ends the step; true where any band changed.
  bool end_step();

 private:
  [[nodiscard]] bool may_change(std::size_t band, int cycle) const;

  int step_ = 0;
  Index active_count_ = 0;
  std::vector<Index> active_;
  std::vector<int> last_change_;
  std::vector<unsigned char> changed_;
};

/// What is repeated: the passes of one cycle, their model, and how many cycles at most.
template <class T>
struct Cycle {
  std::span<const Pass<T>> passes;
  const RuleModel* model = nullptr;
  int most_cycles = std::numeric_limits<int>::max();
};

/// Repeats a cycle until it changes nothing or its limit is reached; returns how many cycles ran,
/// the last one included. Reads `source` once, then alternates between `target` and `scratch`; the
/// result is in `target`. All planes have one size and do not overlap. No allocation.
template <class T>
int iterate(const Cycle<T>& cycle, const ConstPlaneView<T>& source, const PlaneView<T>& target,
            const PlaneView<T>& scratch, BandActivity& activity, ThreadTeam& team);

}  // namespace thinbench
