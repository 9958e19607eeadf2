#include "core/memory_pool.hpp"

#include <algorithm>
#include <limits>
#include <new>

#include "thinbench/memory.hpp"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define THINBENCH_POISONS
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(THINBENCH_POISONS)
#include <sanitizer/asan_interface.h>
#else
#define ASAN_POISON_MEMORY_REGION(address, size) static_cast<void>(address)
#define ASAN_UNPOISON_MEMORY_REGION(address, size) static_cast<void>(address)
#endif

namespace thinbench {
namespace detail {
namespace {

/// Precedes a block in memory.
struct alignas(kAlignment) Header {
  std::size_t bytes;  // of the block
};

void* block_of(Header* header) {
  return header + 1;
}

Header* new_header(std::size_t bytes) {
  constexpr std::size_t limit = std::numeric_limits<std::size_t>::max() - 2 * kAlignment;
  if (bytes > limit) throw std::bad_alloc();
  const std::size_t whole = (bytes + kAlignment - 1) / kAlignment * kAlignment;
  void* const memory = ::operator new (whole + sizeof(Header), std::align_val_t{kAlignment});
  return new (memory) Header{whole};
}

void free_header(Header* header) {
  ::operator delete (header, std::align_val_t{kAlignment});
}

/// Set when the thread's pool is gone, while other objects of the thread may still free blocks.
thread_local bool pool_is_gone = false;

/// Blocks in the order in which they came. There are no locks, hence nothing to hold across fork().
class Pool {
 public:
  Pool() = default;
  ~Pool() {
    release();
    pool_is_gone = true;
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// The smallest block that is large enough, but not much larger; nullptr if there is none.
  Header* take(std::size_t bytes) {
    constexpr std::size_t page = 4096;
    std::size_t best = count_;
    for (std::size_t i = 0; i < count_; ++i) {
      const std::size_t size = blocks_[i]->bytes;
      if (size < bytes || size / 2 > bytes + page) continue;
      if (best == count_ || size < blocks_[best]->bytes) best = i;
    }
    if (best == count_) return nullptr;
    Header* const taken = remove(best);
    ASAN_UNPOISON_MEMORY_REGION(block_of(taken), taken->bytes);
    return taken;
  }

  void give(Header* header) {
    if (header->bytes > kMaxKeptBytes) return free_header(header);
    while (count_ == kMaxKeptBlocks || bytes_ + header->bytes > kMaxKeptBytes) {
      free_header(remove(0));
    }
    bytes_ += header->bytes;
    blocks_[count_++] = header;
    ASAN_POISON_MEMORY_REGION(block_of(header), header->bytes);
  }

  void release() {
    while (count_ > 0) free_header(remove(count_ - 1));
  }

  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  Header* remove(std::size_t i) {
    Header* const removed = blocks_[i];
    std::copy(blocks_ + i + 1, blocks_ + count_, blocks_ + i);
    --count_;
    bytes_ -= removed->bytes;
    return removed;
  }

  Header* blocks_[kMaxKeptBlocks];
  std::size_t count_ = 0;
  std::size_t bytes_ = 0;
};

thread_local Pool pool;

}  // namespace

void* take_block(std::size_t bytes) {
  Header* const kept = pool_is_gone ? nullptr : pool.take(bytes);
  return block_of(kept != nullptr ? kept : new_header(bytes));
}

void give_block(void* block) noexcept {
  if (block == nullptr) return;
  Header* const header = static_cast<Header*>(block) - 1;
  if (pool_is_gone) {
    free_header(header);
  } else {
    pool.give(header);
  }
}

std::size_t kept_bytes() {
  return pool_is_gone ? 0 : pool.bytes();
}

}  // namespace detail

void release_memory() noexcept {
  if (!detail::pool_is_gone) detail::pool.release();
}

}  // namespace thinbench
