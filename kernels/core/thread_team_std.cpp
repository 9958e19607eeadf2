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
    threads_.reserve(static_cast<std::size_t>(count));
    try {
      for (int i = 0; i < count; ++i) threads_.emplace_back([this] { work(); });
    } catch (...) {
      // No more threads or memory: the calling thread and those that started do all parts.
    }
  }

  ~Workers() {
    stopping_ = true;
    wake();
    for (std::thread& thread : threads_) thread.join();
  }

  [[nodiscard]] int count() const { return static_cast<int>(threads_.size()); }

  void run(Index part_count, Index item_count, Invoke invoke_body, const void* loop_body) {
    parts_ = part_count;
    items_ = item_count;
    invoke_ = invoke_body;
    body_ = loop_body;
    error_ = nullptr;
    next_ = 0;
    busy_ = static_cast<int>(threads_.size());
    wake();
    take_parts();
    for (int left = busy_; left > 0; left = busy_) wait_while(busy_, left);
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void wake() {
    ++epoch_;
    notify(epoch_);
  }

  void work() {
    for (unsigned seen = 0;;) {
      wait_while(epoch_, seen);
      seen = epoch_;
      if (stopping_) return;
      {
        const WorkerBlocks blocks;
        take_parts();
      }
      if (--busy_ == 0) notify(busy_);
    }
  }

  void take_parts() {
    for (Index part = next_++; part < parts_; part = next_++) {
      try {
        invoke_(body_, items_ * part / parts_, items_ * (part + 1) / parts_);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!error_) error_ = std::current_exception();
      }
    }
  }

  std::vector<std::thread> threads_;
  std::atomic<unsigned> epoch_ = 0;  // of loops; a new one wakes the threads
  std::atomic<bool> stopping_ = false;
  std::atomic<int> busy_ = 0;  // threads that have not finished the loop
  std::atomic<Index> next_ = 0;
  Index parts_ = 0;
  Index items_ = 0;
  Invoke invoke_ = nullptr;
  const void* body_ = nullptr;
  std::mutex mutex_;  // of `error_`
  std::exception_ptr error_;
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
