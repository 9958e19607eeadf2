// Loops on a fixed number of threads. All threading of the library is here.
#pragma once

#include <memory>
#include <utility>

#include "core/plane_view.hpp"

namespace thinbench::detail {

/// Images below this are faster on one thread: docs/experiments.md#threads.
inline constexpr Index kMinPixelsForThreads = Index{1} << 20;

/// How many of `threads` threads, at least 1, a team gets: with oneTBB no more than there are
/// processors, that the program allows and that the system starts.
[[nodiscard]] int available_threads(int threads);

/// Runs loops by oneTBB or, without it, by std::thread; the calling thread takes part. Workers keep
/// memory in WorkerBlocks. Not thread-safe: one caller at a time.
class ThreadTeam {
 public:
  /// As many threads as are available.
  explicit ThreadTeam(int threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  [[nodiscard]] int threads() const { return threads_; }

  /// Splits [0, count) into one range per thread (at most `count`), calls `body(first, last)` on
  /// each, and returns when all are done. An exception of `body` is thrown again here.
  template <class Body>
  void for_ranges(Index count, const Body& body) const {
    run(count, &invoke<Body>, &body);
  }

 private:
  using Invoke = void (*)(const void* body, Index first, Index last);

  template <class Body>
  static void invoke(const void* body, Index first, Index last) {
    (*static_cast<const Body*>(body))(first, last);
  }

  void run(Index count, Invoke invoke_body, const void* body) const;

  struct Workers;
  std::unique_ptr<Workers> workers_;
  int threads_;
};

}  // namespace thinbench::detail
