#include "counts/cycles.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>

namespace thinbench {
namespace {

constexpr int kAdditionsARound = 16;
constexpr int kRounds = 40000;

/// The loop's own two instructions run beside the chain.
void add_in_a_chain() {
  std::uint64_t sum = 0;
  const std::uint64_t more = 3;
  for (int i = 0; i < kRounds; ++i) {
    asm volatile(
        "add %1, %0\n\tadd %1, %0\n\tadd %1, %0\n\tadd %1, %0\n\t"
        "add %1, %0\n\tadd %1, %0\n\tadd %1, %0\n\tadd %1, %0\n\t"
        "add %1, %0\n\tadd %1, %0\n\tadd %1, %0\n\tadd %1, %0\n\t"
        "add %1, %0\n\tadd %1, %0\n\tadd %1, %0\n\tadd %1, %0"
        : "+r"(sum)
        : "r"(more)
        : "cc");
  }
}

double seconds_of_chain() {
  const double start = thread_seconds();
  add_in_a_chain();
  return thread_seconds() - start;
}

}  // namespace

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_a_cycle() {
  std::array<double, 9> times{};
  for (double& time : times) time = seconds_of_chain();
  std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
  return times[times.size() / 2] / (1.0 * kRounds * kAdditionsARound);
}

}  // namespace thinbench
