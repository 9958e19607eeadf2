#include "core/memory_pool.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <new>

#include "thinbench/memory.hpp"
#include "thinbench/options.hpp"

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

/// Blocks in the order in which they came. There are no locks, hence nothing to hold across fork().
class Pool {
 public:
  constexpr Pool() = default;
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

  Header* blocks_[kMaxKeptBlocks] = {};
  std::size_t count_ = 0;
  std::size_t bytes_ = 0;
};

/// Set when the thread's pool is gone, while other objects of the thread may still free blocks.
thread_local bool pool_is_gone = false;

struct ThreadPool : Pool {
  ~ThreadPool() {
    release();
    pool_is_gone = true;
  }
};

thread_local ThreadPool own_pool;
thread_local Pool* worker_pool = nullptr;  // instead, for a part of a loop

/// The pool of the calling thread, or nullptr.
Pool* current_pool() {
  if (worker_pool != nullptr) return worker_pool;
  return pool_is_gone ? nullptr : &own_pool;
}

/// Pools of workers, used by who has set the flag. Not destroyed: teams in static variables may
/// outlive other static variables.
struct SharedPool {
  std::atomic<bool> is_used = false;
  Pool pool;

  [[nodiscard]] bool try_use() {
    return !is_used.load(std::memory_order_relaxed) &&
           !is_used.exchange(true, std::memory_order_acquire);
  }
  void leave() { is_used.store(false, std::memory_order_release); }
};
constexpr std::size_t kSharedPools = kMaxThreads;
constinit SharedPool shared_pools[kSharedPools];
std::atomic<std::size_t> shared_pool_count = 0;  // those that have ever been used come first

/// Calls `body(pool)` for the pools of workers that have no work.
template <class Body>
void for_idle_pools(const Body& body) {
  const std::size_t count = shared_pool_count;
  for (std::size_t i = 0; i < count; ++i) {
    if (!shared_pools[i].try_use()) continue;
    body(shared_pools[i].pool);
    shared_pools[i].leave();
  }
}

}  // namespace

void* take_block(std::size_t bytes) {
  Pool* const pool = current_pool();
  Header* const kept = pool == nullptr ? nullptr : pool->take(bytes);
  return block_of(kept != nullptr ? kept : new_header(bytes));
}

void give_block(void* block) noexcept {
  if (block == nullptr) return;
  Header* const header = static_cast<Header*>(block) - 1;
  if (Pool* const pool = current_pool()) {
    pool->give(header);
  } else {
    free_header(header);
  }
}

std::size_t kept_bytes() {
  const Pool* const pool = current_pool();
  std::size_t bytes = pool == nullptr ? 0 : pool->bytes();
  for_idle_pools([&](const Pool& idle) { bytes += idle.bytes(); });
  return bytes;
}

WorkerBlocks::WorkerBlocks() noexcept : before_(worker_pool) {
  while (number_ < kSharedPools && !shared_pools[number_].try_use()) ++number_;
  if (number_ == kSharedPools) return;  // more than that are busy: this one uses its own
  std::size_t count = shared_pool_count;
  while (count <= number_ && !shared_pool_count.compare_exchange_weak(count, number_ + 1)) {
  }
  worker_pool = &shared_pools[number_].pool;
}

WorkerBlocks::~WorkerBlocks() {
  if (number_ == kSharedPools) return;
  worker_pool = static_cast<Pool*>(before_);
  shared_pools[number_].leave();
}

}  // namespace detail

void release_memory() noexcept {
  if (detail::Pool* const pool = detail::current_pool()) pool->release();
  detail::for_idle_pools([](detail::Pool& idle) { idle.release(); });
}

}  // namespace thinbench
