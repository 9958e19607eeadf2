// Without oneTBB: a team starts its threads and keeps them.
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#if defined(_WIN32)
#include <windows.h>
#endif

#include "core/memory_pool.hpp"
#include "core/thread_team.hpp"

namespace thinbench::detail {

namespace {

#if defined(_WIN32)
// On Windows GCC's std::atomic::wait may miss a notification, and its condition variables are slow.
template <class Number>
void wait_while(const std::atomic<Number>& number, Number old) {
  static_assert(sizeof number == sizeof old);
  while (number == old) {
    WaitOnAddress(const_cast<std::atomic<Number>*>(&number), &old, sizeof old, INFINITE);
  }
}

template <class Number>
void notify(std::atomic<Number>& number) {
  WakeByAddressAll(&number);
}
#else
template <class Number>
void wait_while(const std::atomic<Number>& number, Number old) {
  number.wait(old);
}

template <class Number>
void notify(std::atomic<Number>& number) {
  number.notify_all();
}
#endif

}  // namespace

/// The threads of a team. An idle thread takes the next part of a loop, so if the system starts
/// fewer threads, loops only take longer.
struct ThreadTeam::Workers {
  explicit Workers(int count) {
    threads.reserve(static_cast<std::size_t>(count));
    try {
      for (int i = 0; i < count; ++i) threads.emplace_back([this] { work(); });
    } catch (...) {
      // No more threads or memory: the calling thread and those that started do all parts.
    }
  }

  ~Workers() {
    stopping = true;
    wake();
    for (std::thread& thread : threads) thread.join();
  }

  [[nodiscard]] int count() const { return static_cast<int>(threads.size()); }

  void run(Index part_count, Index item_count, Invoke invoke_body, const void* loop_body) {
    parts = part_count;
    items = item_count;
    invoke = invoke_body;
    body = loop_body;
    error = nullptr;
    next = 0;
    busy = static_cast<int>(threads.size());
    wake();
    take_parts();
    for (int left = busy; left > 0; left = busy) wait_while(busy, left);
    if (error) std::rethrow_exception(error);
  }

 private:
  void wake() {
    ++epoch;
    notify(epoch);
  }

  void work() {
    for (unsigned seen = 0;;) {
      wait_while(epoch, seen);
      seen = epoch;
      if (stopping) return;
      {
        const WorkerBlocks blocks;
        take_parts();
      }
      if (--busy == 0) notify(busy);
    }
  }

  void take_parts() {
    for (Index part = next++; part < parts; part = next++) {
      try {
        invoke(body, items * part / parts, items * (part + 1) / parts);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!error) error = std::current_exception();
      }
    }
  }

  std::vector<std::thread> threads;
  std::atomic<unsigned> epoch = 0;  // of loops; a new one wakes the threads
  std::atomic<bool> stopping = false;
  std::atomic<int> busy = 0;  // threads that have not finished the loop
  std::atomic<Index> next = 0;
  Index parts = 0;
  Index items = 0;
  Invoke invoke = nullptr;
  const void* body = nullptr;
  std::mutex mutex;  // of `error`
  std::exception_ptr error;
};

int available_threads(int threads) {
  return threads;
}

ThreadTeam::ThreadTeam(int threads)
    : workers_(threads > 1 ? std::make_unique<Workers>(threads - 1) : nullptr),
      threads_(workers_ ? 1 + workers_->count() : 1) {}

ThreadTeam::~ThreadTeam() = default;

void ThreadTeam::run(Index count, Invoke invoke_body, const void* body) const {
  if (threads_ == 1 || count < 2) {
    if (count > 0) invoke_body(body, 0, count);
    return;
  }
  workers_->run(count < threads_ ? count : threads_, count, invoke_body, body);
}

}  // namespace thinbench::detail
