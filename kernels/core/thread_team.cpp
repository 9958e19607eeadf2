#include "core/thread_team.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include "core/shared_loop.hpp"

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace thinbench {
namespace {

// Threads hand work over and wait for each other inside oneTBB's library, which is not compiled
// with the thread sanitizer. These two tell it what the library guarantees: all before
// `publish(token)` happens before all after `receive(token)`.
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

// How many threads really run is up to oneTBB's global limit, which belongs to the program and not
// to a library: by default no more than the machine has cores.
struct ThreadTeam::Arena {
  explicit Arena(int threads) : arena(threads) {}
  tbb::task_arena arena;
  SharedLoop* awake = nullptr;  // while helpers are
};

ThreadTeam::ThreadTeam(int threads)
    : arena_(threads > 1 ? std::make_unique<Arena>(threads) : nullptr), threads_(threads) {}

ThreadTeam::~ThreadTeam() = default;

namespace {

/// What a loop calls for each of its parts.
struct Ranges {
  void (*invoke)(const void* body, Index first, Index last);
  const void* body;
  Index count;

  void run(Index part, Index parts) const {
    invoke(body, count * part / parts, count * (part + 1) / parts);
  }
};

/// Helpers that stay awake as long as this lives. Those that come late, or never, are not missed.
class Helpers {
 public:
  Helpers(SharedLoop& loop, int count) : loop_(loop) {
    publish(&loop_);
    for (int i = 0; i < count; ++i) {
      group_.run([this] {
        receive(&loop_);
        loop_.help();
        publish(&group_);
      });
    }
  }
  ~Helpers() {
    loop_.close();
    group_.wait();
    receive(&group_);
  }
  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;

 private:
  SharedLoop& loop_;
  tbb::task_group group_;
};

}  // namespace

void ThreadTeam::run(Index count, Invoke invoke_body, const void* body) const {
  if (threads_ == 1 || count < 2) {
    if (count > 0) invoke_body(body, 0, count);
    return;
  }
  const Index parts = count < threads_ ? count : threads_;
  const Ranges ranges = {invoke_body, body, count};
  if (arena_->awake != nullptr) {
    arena_->awake->offer([](const void* all, Index part,
                            Index of) { static_cast<const Ranges*>(all)->run(part, of); },
                         &ranges, parts);
    return;
  }
  const void* finished = arena_.get();
  publish(body);
  arena_->arena.execute([=] {
    tbb::parallel_for(
        Index{0}, parts,
        [=](Index part) {
          receive(body);
          ranges.run(part, parts);
          publish(finished);
        },
        tbb::static_partitioner{});
  });
  receive(finished);
}

void ThreadTeam::run_awake(InvokeAll invoke_body, const void* body) const {
  if (threads_ == 1 || arena_->awake != nullptr) {
    invoke_body(body);
    return;
  }
  arena_->arena.execute([&] {
    SharedLoop loop;
    const Helpers helpers(loop, threads_ - 1);
    arena_->awake = &loop;
    struct Asleep {
      Arena& arena;
      ~Asleep() { arena.awake = nullptr; }
    } asleep{*arena_};
    invoke_body(body);
  });
}

}  // namespace thinbench
