// Memory for states and images. Freed blocks are kept for the thread's next calls, so that a
// function that makes a state each time takes no new pages.
#pragma once

#include <cstddef>

namespace thinbench::detail {

/// The size of a cache line. Every row that this library allocates starts on one.
inline constexpr std::size_t kAlignment = 64;

/// A thread keeps at most so many blocks and bytes.
inline constexpr std::size_t kMaxKeptBlocks = 32;
inline constexpr std::size_t kMaxKeptBytes = std::size_t{8} << 20;

/// A block with any contents, aligned to a cache line: one that is kept, unless it has more than
/// twice the size and some pages, else a new one. Throws std::bad_alloc.
[[nodiscard]] void* take_block(std::size_t bytes);

/// Keeps the block for the calling thread, or frees it: the longest kept ones go first. May be
/// another thread than that which took it. Nothing is kept by a thread that ends.
void give_block(void* block) noexcept;

/// Bytes that release_memory() frees: what the calling thread keeps, and workers of teams that have
/// no work.
[[nodiscard]] std::size_t kept_bytes();

/// What the calling thread, a worker of a team, uses instead of its own blocks as long as this
/// exists: blocks that such a worker has kept. Those of a thread cannot be freed by another.
class WorkerBlocks {
 public:
  WorkerBlocks() noexcept;
  ~WorkerBlocks();
  WorkerBlocks(const WorkerBlocks&) = delete;
  WorkerBlocks& operator=(const WorkerBlocks&) = delete;

 private:
  void* before_;  // what the thread used
  std::size_t number_ = 0;
};

}  // namespace thinbench::detail
