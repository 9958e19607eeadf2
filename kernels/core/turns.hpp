// Pieces of work of unequal size, shared among threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

#include "core/thread_team.hpp"

namespace thinbench::detail {

/// The maximum of worker(i) over all i below `count`, 0 if there are none. Threads take the next i
/// when they are free; each calls `make_worker()` once and then its own worker.
template <class MakeWorker>
[[nodiscard]] int maximum_in_turns(const ThreadTeam& team, std::size_t count,
                                   const MakeWorker& make_worker) {
  std::atomic<std::size_t> next = 0;
  std::vector<int> maxima(static_cast<std::size_t>(team.threads()));
  team.for_ranges(team.threads(), [&](Index first, Index) {
    auto worker = make_worker();
    int& maximum = maxima[static_cast<std::size_t>(first)];
    for (std::size_t i = next++; i < count; i = next++) maximum = std::max(maximum, worker(i));
  });
  return *std::max_element(maxima.begin(), maxima.end());
}

}  // namespace thinbench::detail
