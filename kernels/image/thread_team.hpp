// Loops on a fixed number of threads: all threading of the library.
#pragma once

#include <memory>
#include <utility>

#include "image/plane_view.hpp"

namespace thinbench::detail {

/// Smaller images are faster on one thread: docs/experiments.md#threads-on-small-images.
inline constexpr Index kMinPixelsForThreads = Index{1} << 20;

/// Runs loops by oneTBB; the calling thread is one of the threads. A team serves one caller at a
/// time.
class ThreadTeam {
 public:
  /// Needs threads >= 1.
  explicit ThreadTeam(int threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;
  ThreadTeam(ThreadTeam&&) = delete;
  ThreadTeam& operator=(ThreadTeam&&) = delete;

  [[nodiscard]] int threads() const { return threads_; }

  /// Calls `body(first, last)` on as many disjoint ranges as there are threads, which cover
  /// [0, count), and returns when all are done.
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

  struct Arena;
  std::unique_ptr<Arena> arena_;
  int threads_;
};

}  // namespace thinbench::detail
