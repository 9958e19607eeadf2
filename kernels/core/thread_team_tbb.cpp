#include <algorithm>
#include <map>
#include <mutex>
#include <new>
#include <optional>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "core/memory_pool.hpp"
#include "core/startable_threads.hpp"
#include "core/thread_team.hpp"

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace thinbench::detail {
namespace {

// oneTBB synchronises the threads but is not compiled with ThreadSanitizer. These functions declare
// what oneTBB guarantees: `publish(token)` happens before `receive(token)`.
#ifdef __SANITIZE_THREAD__
void publish(const void* token) {
  __tsan_release(const_cast<void*>(token));
}
void receive(const void* token) {
  __tsan_acquire(const_cast<void*>(token));
}
#else
void publish(const void*) {}
void receive(const void*) {}
#endif

// oneTBB's global limit, which the program controls, may reduce the number of threads; by default
// to the number of cores. An arena beyond it would print a warning.
std::size_t global_limit() {
  using tbb::global_control;
  return global_control::active_value(global_control::max_allowed_parallelism);
}

// The first call of oneTBB starts it. Where memory was too short for that, the next one would wait
// for ever, and so would one in another thread.
bool has_started() {
  static const bool started = [] {
    try {
      return global_limit() > 0;
    } catch (const std::bad_alloc&) {
      return false;
    }
  }();
  return started;
}

/// Its address tells threads apart.
thread_local char thread_mark = 0;

/// Arenas by size. What a team takes and gives back is the node, so neither needs memory twice.
using Arenas = std::multimap<int, tbb::task_arena>;

/// Arenas that no team uses. oneTBB may keep the memory of arenas that are destroyed while its
/// workers are busy elsewhere, without a bound; those that are used again are as many as teams at
/// once.
class ArenaPool {
 public:
  [[nodiscard]] Arenas::node_type take(int size) {
    const std::lock_guard lock(mutex_);
    auto place = unused_.find(size);
    if (place == unused_.end()) place = unused_.emplace(size, size);
    return unused_.extract(place);
  }

  void give_back(Arenas::node_type arena) {
    const std::lock_guard lock(mutex_);
    unused_.insert(std::move(arena));
  }

 private:
  std::mutex mutex_;
  Arenas unused_;
};

/// Never destroyed: teams in static variables may outlive other static variables.
ArenaPool& arena_pool() {
  static auto& pool = *new ArenaPool;
  return pool;
}

}  // namespace

int available_threads(int threads) {
  if (threads == 1 || !has_started()) return 1;
  return startable_threads(std::min(threads, static_cast<int>(global_limit())));
}

struct ThreadTeam::Workers {
  explicit Workers(int size) : arena(arena_pool().take(size)) {}
  ~Workers() { arena_pool().give_back(std::move(arena)); }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  Arenas::node_type arena;
};

ThreadTeam::ThreadTeam(int threads) : threads_(available_threads(threads)) {
  if (threads_ > 1) workers_ = std::make_unique<Workers>(threads_);
}

ThreadTeam::~ThreadTeam() = default;

void ThreadTeam::run(Index count, Invoke invoke_body, const void* body) const {
  if (threads_ == 1 || count < 2) {
    if (count > 0) invoke_body(body, 0, count);
    return;
  }
  const Index parts = count < threads_ ? count : threads_;
  const void* finished = workers_.get();
  const char* const caller = &thread_mark;
  publish(body);
  workers_->arena.mapped().execute([=] {
    // Not static_partitioner: it leaves a message for the worker of each part, and where workers
    // are busy elsewhere messages stay in memory.
    tbb::parallel_for(
        Index{0}, parts,
        [=](Index part) {
          receive(body);
          std::optional<WorkerBlocks> blocks;
          if (&thread_mark != caller) blocks.emplace();
          invoke_body(body, count * part / parts, count * (part + 1) / parts);
          blocks.reset();
          publish(finished);
        },
        tbb::simple_partitioner{});
  });
  receive(finished);
}

}  // namespace thinbench::detail
