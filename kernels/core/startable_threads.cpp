#include "core/startable_threads.hpp"

#include <algorithm>
#include <atomic>
#include <climits>
#include <fstream>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

#include <sys/resource.h>
#include <unistd.h>

namespace thinbench::detail {
namespace {

/// Starts threads that exist at the same time, `wanted` at most, and ends them. Returns how many.
int started_threads(int wanted) {
  std::atomic<bool> ending = false;
  std::vector<std::thread> threads;
  try {
    threads.reserve(static_cast<std::size_t>(wanted));
    for (int i = 0; i < wanted; ++i) {
      threads.emplace_back([&ending] {
        const std::unique_ptr<int> heap(new (std::nothrow) int);  // which each thread maps
        ending.wait(false);
      });
    }
  } catch (const std::system_error&) {  // this is what was to be found out
  } catch (const std::bad_alloc&) {
  }
  ending = true;
  ending.notify_all();
  for (std::thread& thread : threads) thread.join();
  return static_cast<int>(threads.size());
}

/// The threads for which a quarter of the address space that is left suffices, the calling one
/// included: each takes a stack and a heap, and oneTBB starts them when other memory is used, too.
int threads_in_address_space() {
  constexpr rlim_t bytes_per_thread = rlim_t{72} << 20;
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return INT_MAX;
  rlim_t used_pages = 0;
  std::ifstream("/proc/self/statm") >> used_pages;
  const rlim_t used = used_pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
  const rlim_t left = limit.rlim_cur > used ? limit.rlim_cur - used : 0;
  return 1 + static_cast<int>(std::min<rlim_t>(left / 4 / bytes_per_thread, INT_MAX - 1));
}

/// The limits of this process that decide how many threads start.
struct Limits {
  rlim_t processes;
  rlim_t address_space;

  bool operator==(const Limits&) const = default;
};

Limits current_limits() {
  rlimit processes{};
  rlimit address_space{};
  getrlimit(RLIMIT_NPROC, &processes);
  getrlimit(RLIMIT_AS, &address_space);
  return {processes.rlim_cur, address_space.rlim_cur};
}

}  // namespace

// At the limit, half of it is left to the rest of the program and to other programs of the user.
int startable_threads(int wanted) {
  static std::mutex mutex;
  static int known = 1;                    // the most that have run
  static std::optional<Limits> failed_at;  // where more did not start
  const std::lock_guard lock(mutex);
  if (wanted <= known) return wanted;
  const Limits limits = current_limits();
  const int tried = std::min(wanted, threads_in_address_space());
  if (tried <= known || failed_at == limits) return known;
  const int started = started_threads(tried - 1) + 1;
  if (started < tried) failed_at = limits;
  known = std::max(known, started == tried ? tried : started / 2);
  return known;
}

}  // namespace thinbench::detail
