#include "core/memory_pool.hpp"

#include <algorithm>
#include <limits>
#include <new>

#include "thinbench/memory.hpp"

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
  Pool() = default;
  ~Pool() { release(); }
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

// The pool of the calling thread. nullptr when it is gone, while other objects of the thread may
// still free blocks.
#ifdef _WIN32
// There GCC frees thread-local objects before it destroys them, so the system keeps the pools.
char gone;  // its address stands for a pool that is gone

extern const DWORD pool_index;

void destroy_pool(void* pool) {
  if (pool == &gone) return;
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
  ~PoolOfThread() { pool_is_gone = true; }
  Pool pool;
};
thread_local PoolOfThread of_thread;

Pool* pool_of_thread() {
  return pool_is_gone ? nullptr : &of_thread.pool;
}
#endif

}  // namespace

void* take_block(std::size_t bytes) {
  Pool* const pool = pool_of_thread();
  Header* const kept = pool == nullptr ? nullptr : pool->take(bytes);
  return block_of(kept != nullptr ? kept : new_header(bytes));
}

void give_block(void* block) noexcept {
  if (block == nullptr) return;
  Header* const header = static_cast<Header*>(block) - 1;
  if (Pool* const pool = pool_of_thread()) {
    pool->give(header);
  } else {
    free_header(header);
  }
}

std::size_t kept_bytes() {
  const Pool* const pool = pool_of_thread();
  return pool == nullptr ? 0 : pool->bytes();
}

}  // namespace detail

void release_memory() noexcept {
  if (detail::Pool* const pool = detail::pool_of_thread()) pool->release();
}

}  // namespace thinbench
