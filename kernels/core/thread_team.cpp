#include "core/thread_team.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace thinbench {

// How many threads really run is up to oneTBB's global limit, which belongs to the program and not
// to a library: by default no more than the machine has cores.
struct ThreadTeam::Arena {
  explicit Arena(int threads) : arena(threads) {}
  tbb::task_arena arena;
};

ThreadTeam::ThreadTeam(int threads)
    : arena_(threads > 1 ? std::make_unique<Arena>(threads) : nullptr), threads_(threads) {}

ThreadTeam::~ThreadTeam() = default;

void ThreadTeam::run(Index count, Invoke invoke_body, const void* body) {
  if (threads_ == 1 || count < 2) {
    if (count > 0) invoke_body(body, 0, count);
    return;
  }
  const Index parts = count < threads_ ? count : threads_;
  arena_->arena.execute([=] {
    tbb::parallel_for(
        Index{0}, parts,
        [=](Index part) { invoke_body(body, count * part / parts, count * (part + 1) / parts); },
        tbb::static_partitioner{});
  });
}

}  // namespace thinbench
