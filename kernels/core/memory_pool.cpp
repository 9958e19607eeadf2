#include "core/memory_pool.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <new>

#include "thinbench/memory.hpp"
#include "thinbench/options.hpp"

#ifdef _WIN32
#include <windows.h>
#endif

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

// The pool of a thread. nullptr when it is gone, while other objects of the thread may
// still free blocks.
#ifdef _WIN32
// There GCC frees thread-local objects before it destroys them, so the system keeps the pools.
char gone;  // its address stands for a pool that is gone

extern const DWORD pool_index;

void destroy_pool(void* pool) {
  if (pool == &gone) return;
  static_cast<Pool*>(pool)->release();
  delete static_cast<Pool*>(pool);
  FlsSetValue(pool_index, &gone);
}

/// From now on a DLL with this library remains loaded, as each thread that ends calls destroy_pool.
DWORD make_pool_index() {
  HMODULE library = nullptr;
  GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_PIN | GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS,
                     reinterpret_cast<LPCWSTR>(&destroy_pool), &library);
  return FlsAlloc(&destroy_pool);
}

const DWORD pool_index = make_pool_index();

Pool* pool_of_thread() {
  void* pool = FlsGetValue(pool_index);
  if (pool == &gone) return nullptr;
  if (pool == nullptr) {
    pool = new (std::nothrow) Pool;
    FlsSetValue(pool_index, pool);
  }
  return static_cast<Pool*>(pool);
}
#else
thread_local bool pool_is_gone = false;

struct PoolOfThread {
  ~PoolOfThread() {
    pool.release();
    pool_is_gone = true;
  }
  Pool pool;
};
thread_local PoolOfThread of_thread;

Pool* pool_of_thread() {
  return pool_is_gone ? nullptr : &of_thread.pool;
}
#endif

thread_local Pool* worker_pool = nullptr;  // instead, for a part of a loop

/// Of the calling thread, or nullptr.
Pool* current_pool() {
  return worker_pool != nullptr ? worker_pool : pool_of_thread();
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
