#include "measure/probe.hpp"

#include <cstdint>
#include <ctime>
#include <utility>

namespace thinbench {
namespace {

double nanoseconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

/// Additions that wait for each other, with no jump in between. `step` is a register: some
/// processors add constants without taking a cycle.
template <std::size_t... i>
std::uint64_t chain(std::uint64_t sum, std::uint64_t step, std::index_sequence<i...>) {
  const auto add = [&](std::size_t) {
    sum += step;
    asm volatile("" : "+r"(sum), "+r"(step));
  };
  (add(i), ...);
  return sum;
}

/// Sums that do not wait for each other, 16 in each step: half of integers, half of vectors. They
/// are long and start at a cache line: some processors keep only a few instructions of a line ready
/// and would be held up by that, neighbour or not.
void add_independently(std::int64_t steps) {
#if defined(__x86_64__)
  asm volatile(
      ".p2align 6\n 1:\n"
      "lea 256(%%r8), %%rax\n paddd %%xmm8, %%xmm0\n lea 256(%%r8), %%rcx\n paddd %%xmm8, %%xmm1\n "
      "lea 256(%%r8), %%rdx\n paddd %%xmm8, %%xmm2\n lea 256(%%r8), %%rsi\n paddd %%xmm8, %%xmm3\n"
      "lea 256(%%r8), %%rax\n paddd %%xmm8, %%xmm4\n lea 256(%%r8), %%rcx\n paddd %%xmm8, %%xmm5\n "
      "lea 256(%%r8), %%rdx\n paddd %%xmm8, %%xmm6\n lea 256(%%r8), %%rsi\n paddd %%xmm8, %%xmm7\n"
      "sub $1, %0\n jne 1b"
      : "+r"(steps)
      :
      : "rax", "rcx", "rdx", "rsi", "r8", "xmm0", "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6",
        "xmm7", "xmm8", "cc");
#else
  std::uint64_t a = 0, b = 0, c = 0, d = 0;
  for (; steps > 0; --steps) {
    a += 1, b += 1, c += 1, d += 1;
    asm volatile("" : "+r"(a), "+r"(b), "+r"(c), "+r"(d));  // keeps every addition
  }
#endif
}

}  // namespace

double probe_ns() {
  constexpr std::int64_t kSteps = 10000;
  const double start = nanoseconds_now();
  add_independently(kSteps);
  return nanoseconds_now() - start;
}

double cycle_ns() {
  constexpr std::size_t kUnrolled = 100;
  constexpr std::size_t kRepetitions = 200;
  const double start = nanoseconds_now();
  std::uint64_t sum = 1;
  for (std::size_t i = 0; i < kRepetitions; ++i) {
    sum = chain(sum, i, std::make_index_sequence<kUnrolled>());
  }
  return (nanoseconds_now() - start) / (kUnrolled * kRepetitions);
}

void wait_cycles(double cycles) {
  constexpr std::size_t kUnrolled = 100;
  std::uint64_t sum = 1;
  for (std::uint64_t done = 0; static_cast<double>(done) < cycles; done += kUnrolled) {
    sum = chain(sum, done, std::make_index_sequence<kUnrolled>());
  }
}

}  // namespace thinbench
