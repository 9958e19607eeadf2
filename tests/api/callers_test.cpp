// Calls from a thread with little stack, after a call that failed for want of memory, and while the
// program ends: after main, when static variables that were made later are destroyed. A program of
// its own, as in others some were made, and threads started, earlier.
#include <atomic>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include <pthread.h>
#include <unistd.h>
#if __has_include(<sys/wait.h>)
#include <sys/wait.h>
#endif

#include "core/byte_image.hpp"
#include "harness/splitmix64.hpp"
#include "thinbench.h"
#include "thinbench/distance.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/graph.hpp"
#include "thinbench/localise.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/rule_notation.hpp"
#include "thinbench/thinning.hpp"

namespace {
std::atomic<long> available = LONG_MAX;  // allocations until the one that fails
std::atomic<bool> has_failed = false;

[[noreturn]] void fail_slowly() {
  has_failed = true;
  usleep(20'000);  // for others to begin a call
  throw std::bad_alloc();
}
}  // namespace

[[gnu::noinline]] void* operator new(std::size_t size) {
  if (available-- == 0) fail_slowly();
  void* const memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace thinbench {
namespace {

detail::ByteImage test_image(Index width, Index height) {
  detail::ByteImage image(width, height);
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      image.at(x, y) = splitmix64(1, static_cast<std::uint64_t>(y / 5 * 1000 + x / 7)) % 3 != 0;
    }
  }
  return image;
}

/// Pixels of every rule, and what all other operations count.
std::uint64_t results_of_every_operation() {
  const detail::ByteImage image = test_image(700, 90);  // in tiles
  detail::ByteImage result(image.width(), image.height());
  std::uint64_t sum = 0;
  const auto add = [&] {
    for (Index y = 0; y < result.height(); ++y) {
      for (Index x = 0; x < result.width(); ++x) sum = sum * 31 + result.at(x, y);
    }
  };
  for (const RuleInfo& info : kRules) {
    thin(info.rule, image.view(), result.view());
    add();
  }
  const Rule life(table_from_hensel("B3/S23"), {.max_iterations = 3});
  for (const Isa isa : all_isas()) {
    if (!isa_available(isa)) continue;
    thin(life, image.view(), result.view(), {}, {.isa = isa});
    add();
  }
  detect_edges(EdgeOperator::sobel, image.view(), result.view(), {}, {});
  add();
  std::vector<std::int32_t> numbers(static_cast<std::size_t>(image.width() * image.height()));
  const LabelView labels = {numbers.data(), image.width(), image.height()};
  squared_distances(image.view(), labels);
  for (const std::int32_t number : numbers) sum = sum * 31 + static_cast<std::uint32_t>(number);
  sum += static_cast<std::uint64_t>(label_image(image.view(), labels, Connectivity::eight));
  sum += find_regions(image.view()).objects.size();
  sum += localise_objects(image.view(), {}, {}).objects.size();
  sum += skeleton_graph(image.view()).edges.size();
  return sum;
}

std::string message_of_a_failure() {
  std::uint64_t table[8];
  thinbench_table_from_hensel("B3/S23 and more than a short message", table);
  return thinbench_last_error();
}

std::uint64_t expected = 0;
std::string failure;

[[noreturn]] void fail(const char* where) {
  std::fprintf(stderr, "other results %s\n", where);
  _exit(1);
}

#if __has_include(<sys/wait.h>)
/// Whether two threads can be used while and after an allocation of the first call with two fails.
/// In a process of its own.
bool works_after_failure_at(long allocation) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);  // ends a call that waits for ever
    const detail::ByteImage image = test_image(1100, 1000);
    const auto works = [&] { return !find_regions(image.view(), {.threads = 2}).objects.empty(); };
    std::thread first([&] {
      try {
        available = allocation;
        static_cast<void>(works());
      } catch (const std::bad_alloc&) {
      }
      available = LONG_MAX;
      has_failed = true;  // or has not, with so many allocations
    });
    while (!has_failed) std::this_thread::yield();
    const bool works_meanwhile = works();
    first.join();
    _exit(works_meanwhile && works() ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status == 0;
}
#endif

void call_after_main() {
  if (results_of_every_operation() != expected) fail("after main");
  if (message_of_a_failure() != failure) fail("in a message after main");
}

void* call_in_thread(void*) {
  if (results_of_every_operation() != expected) fail("in a thread");
  return nullptr;
}

#ifdef THINBENCH_SANITIZED  // sanitizers take more
constexpr std::size_t kStackBytes = std::size_t{8} << 20;
#else
/// What docs/library.md promises.
constexpr std::size_t kStackBytes = std::size_t{128} << 10;
#endif

}  // namespace
}  // namespace thinbench

int main() {
#if __has_include(<sys/wait.h>)
  for (long i = 0; i < 80; ++i) {
    if (!thinbench::works_after_failure_at(i)) thinbench::fail("after a failed allocation");
  }
#endif
  if (std::atexit(&thinbench::call_after_main) != 0) return 2;
  thinbench::expected = thinbench::results_of_every_operation();
  thinbench::failure = thinbench::message_of_a_failure();
  pthread_attr_t attributes;
  pthread_t thread{};
  pthread_attr_init(&attributes);
  if (pthread_attr_setstacksize(&attributes, thinbench::kStackBytes) != 0) return 2;
  if (pthread_create(&thread, &attributes, &thinbench::call_in_thread, nullptr) != 0) return 2;
  pthread_join(thread, nullptr);
}
