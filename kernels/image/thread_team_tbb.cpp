#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

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

}  // namespace

// oneTBB's global limit, which the program controls, may reduce the number of threads; by default
// to the number of cores.
struct ThreadTeam::Workers {
  explicit Workers(int threads) : arena(threads) {}
  tbb::task_arena arena;
};

ThreadTeam::ThreadTeam(int threads)
    : workers_(threads > 1 ? std::make_unique<Workers>(threads) : nullptr), threads_(threads) {}

ThreadTeam::~ThreadTeam() = default;

void ThreadTeam::run(Index count, Invoke invoke_body, const void* body) const {
  if (threads_ == 1 || count < 2) {
    if (count > 0) invoke_body(body, 0, count);
    return;
  }
  const Index parts = count < threads_ ? count : threads_;
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
