#include "measure/measuring.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <optional>
#include <stdexcept>
#include <utility>

#include "harness/splitmix64.hpp"
#include "measure/timed_call.hpp"
#include "measure/workspace.hpp"

namespace thinbench {
namespace {

/// On the wall: in a virtual machine the clock of a thread sometimes omits time that it worked.
double nanoseconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

/// Additions that wait for each other, with no jump in between. `step` is a register: some
/// processors add constants without taking a cycle.
template <std::size_t... i>
std::uint64_t sum_of(std::uint64_t sum, std::uint64_t step, std::index_sequence<i...>) {
  const auto add = [&](std::size_t) {
    sum += step;
    asm volatile("" : "+r"(sum), "+r"(step));
  };
  (add(i), ...);
  return sum;
}

/// Returns after at least `cycles` clock cycles.
void wait_cycles(double cycles) {
  constexpr std::size_t kUnrolled = 100;
  std::uint64_t sum = 1;
  for (std::uint64_t done = 0; static_cast<double>(done) < cycles; done += kUnrolled) {
    sum = sum_of(sum, done, std::make_index_sequence<kUnrolled>());
  }
}

/// Memory of random size between what is allocated, kept to the end: large blocks
/// would lie at the same place of a page in every layout, and by chance at a good or a bad one.
class Gaps {
 public:
  explicit Gaps(std::uint64_t seed) : seed_(seed) {}

  void add() {
    constexpr std::uint64_t kLines = 64;
    const std::size_t bytes = detail::kAlignment * (splitmix64(seed_, gaps_.size()) % kLines);
    gaps_.push_back(detail::make_aligned<std::uint8_t>(bytes));
  }

 private:
  std::uint64_t seed_;
  std::vector<detail::AlignedArray<std::uint8_t>> gaps_;
};

/// The calls of a group in one layout. Every entry has a job of its own, controls too.
class Calls {
 public:
  Calls(const Group& group, double plan_cycle, std::uint64_t seed,
        const std::vector<Operation>& operations, const std::vector<TimedInput>& inputs, Gaps& gaps)
      : group_(group),
        plan_cycle_(plan_cycle),
        workspace_(row_named(group.entries.front().name, operations, inputs).view()),
        calls_(group.entries.size()),
        checked_(group.entries.size(), false) {
    for (const std::size_t i : shuffled(group.entries.size(), seed)) {
      gaps.add();
      calls_[i].emplace(row_named(group.entries[i].name, operations, inputs), workspace_.source(),
                        workspace_.destination());
    }
  }

  /// Untimed calls come first because caches are as the calls of another row left them.
  double visit(std::size_t index) {
    const Entry& entry = group_.entries[index];
    TimedCall& call = *calls_[index];
    for (std::int64_t i = 0; i < entry.warm_up; ++i) call();
    const double time = epoch(entry, call);
    if (!checked_[index]) check(entry, call);
    checked_[index] = true;
    return time;
  }

 private:
  /// The clock of a processor changes within a millisecond. So its cycle is measured between parts
  /// of the epoch, and the shortest one counts: an interrupted sample would seem a slow clock.
  double epoch(const Entry& entry, TimedCall& call) const {
    constexpr std::int64_t kParts = 4;
    const std::int64_t part = (entry.calls + kParts - 1) / kParts;
    const double delay = entry.delay_ns / plan_cycle_;
    double cycle = cycle_ns();
    double time = 0;
    for (std::int64_t left = entry.calls; left > 0; left -= part) {
      const std::int64_t calls = std::min(part, left);
      const double start = nanoseconds_now();
      for (std::int64_t i = 0; i < calls; ++i) call();
      if (delay > 0) wait_cycles(delay * static_cast<double>(calls));
      time += nanoseconds_now() - start;
      cycle = std::min(cycle, cycle_ns());
    }
    return time / cycle * plan_cycle_;
  }

  static void check(const Entry& entry, const TimedCall& call) {
    const std::string hash = hash_of(call.outcome());
    if (hash == entry.hash) return;
    throw std::runtime_error(entry.name + " gave another result (" + hash +
                             ") than was verified (" + entry.hash + ")");
  }

  const Group& group_;
  double plan_cycle_;
  Workspace workspace_;
  std::vector<std::optional<TimedCall>> calls_;
  std::vector<bool> checked_;
};

}  // namespace

std::string hash_of(const Outcome& outcome) {
  std::uint64_t hash = std::stoull(pixel_hash(outcome.image.view()), nullptr, 16);
  for (const std::int64_t number : outcome.numbers) {
    hash = splitmix64(hash ^ static_cast<std::uint64_t>(number));
  }
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

void measure(const Plan& plan, std::uint64_t seed, const std::vector<Operation>& operations,
             const std::vector<TimedInput>& inputs,
             const std::function<void(const GroupTimes&)>& sink) {
  int layouts = 0;
  for (const Group& group : plan.groups) layouts = std::max(layouts, group.layouts);
  Gaps gaps(seed);
  for (int layout = 0; layout < layouts; ++layout) {
    const std::uint64_t layout_seed = splitmix64(seed, static_cast<std::uint64_t>(layout));
    for (const std::size_t index : shuffled(plan.groups.size(), layout_seed)) {
      const Group& group = plan.groups[index];
      if (layout >= group.layouts) continue;
      const std::uint64_t group_seed = splitmix64(layout_seed, index);
      Calls calls(group, plan.cycle_ns, group_seed, operations, inputs, gaps);
      const auto visit = [&](std::size_t entry) { return calls.visit(entry); };
      sink({index, measure_rounds(group.entries, group_seed, visit)});
    }
  }
}

double cycle_ns() {
  constexpr std::size_t kUnrolled = 100;
  constexpr std::size_t kRepetitions = 200;
  const double start = nanoseconds_now();
  std::uint64_t sum = 1;
  for (std::size_t i = 0; i < kRepetitions; ++i) {
    sum = sum_of(sum, i, std::make_index_sequence<kUnrolled>());
  }
  return (nanoseconds_now() - start) / (kUnrolled * kRepetitions);
}

double shortest_cycle_ns() {
  constexpr int kSamples = 400;
  double shortest = cycle_ns();
  for (int sample = 1; sample < kSamples; ++sample) shortest = std::min(shortest, cycle_ns());
  return shortest;
}

}  // namespace thinbench
