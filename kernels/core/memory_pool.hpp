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

/// Bytes that the calling thread keeps.
[[nodiscard]] std::size_t kept_bytes();

}  // namespace thinbench::detail
