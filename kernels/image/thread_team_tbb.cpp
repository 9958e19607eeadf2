#include <algorithm>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "image/startable_threads.hpp"
#include "image/thread_team.hpp"

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
int arena_size(int threads) {
  using tbb::global_control;
  const std::size_t limit = global_control::active_value(global_control::max_allowed_parallelism);
  return startable_threads(std::min(threads, static_cast<int>(limit)));
}

}  // namespace

struct ThreadTeam::Workers {
  explicit Workers(int size) : arena(size) {}
  tbb::task_arena arena;
};

// Without workers, the calling thread does all parts.
ThreadTeam::ThreadTeam(int threads) : threads_(threads) {
  const int size = threads > 1 ? arena_size(threads) : 1;
  if (size > 1) workers_ = std::make_unique<Workers>(size);
}

ThreadTeam::~ThreadTeam() = default;

void ThreadTeam::run(Index count, Invoke invoke_body, const void* body) const {
  if (threads_ == 1 || count < 2) {
    if (count > 0) invoke_body(body, 0, count);
    return;
  }
  const Index parts = count < threads_ ? count : threads_;
  if (!workers_) {
    for (Index part = 0; part < parts; ++part) {
      invoke_body(body, count * part / parts, count * (part + 1) / parts);
    }
    return;
  }
  const void* finished = workers_.get();
  publish(body);
  workers_->arena.execute([=] {
    tbb::parallel_for(
        Index{0}, parts,
        [=](Index part) {
          receive(body);
          invoke_body(body, count * part / parts, count * (part + 1) / parts);
          publish(finished);
        },
        tbb::static_partitioner{});
  });
  receive(finished);
}

}  // namespace thinbench::detail
