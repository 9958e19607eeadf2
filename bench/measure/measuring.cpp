#include "measure/measuring.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <map>
#include <set>
#include <stdexcept>

#include "harness/splitmix64.hpp"
#include "measure/timed_call.hpp"
#include "measure/workspace.hpp"

namespace thinbench {
namespace {

double nanoseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

Times now() {
  const double wall = nanoseconds(CLOCK_MONOTONIC);
  return {nanoseconds(CLOCK_THREAD_CPUTIME_ID), wall};
}

/// The calls of a group by name: entries of the same name share one, so that controls are made of
/// the very same memory.
class Calls {
 public:
  Calls(const Group& group, std::uint64_t seed, const std::vector<Operation>& operations,
        const std::vector<TimedInput>& inputs)
      : group_(group),
        workspace_(row_named(group.entries.front().name, operations, inputs).view()) {
    for (const std::size_t i : shuffled(group.entries.size(), seed)) {
      const std::string& name = group.entries[i].name;
      gaps_.push_back(
          detail::make_aligned<std::uint8_t>(detail::kAlignment * (splitmix64(seed, i) % 64)));
      calls_.try_emplace(name, row_named(name, operations, inputs), workspace_.source(),
                         workspace_.destination());
    }
  }

  /// Untimed calls come first because caches are as the calls of another row left them.
  Times visit(std::size_t index) {
    const Entry& entry = group_.entries[index];
    TimedCall& call = calls_.at(entry.name);
    for (std::int64_t i = 0; i < entry.warm_up; ++i) call();
    const Times start = now();
    for (std::int64_t i = 0; i < entry.calls; ++i) call();
    const Times end = now();
    if (checked_.insert(index).second) check(entry, call);
    return {end.thread_cpu - start.thread_cpu, end.wall - start.wall};
  }

  [[nodiscard]] std::vector<std::size_t> layout() const {
    const auto place = [](const std::uint8_t* data) {
      return static_cast<std::size_t>(reinterpret_cast<std::uintptr_t>(data) % kPage);
    };
    return {place(workspace_.source().data), place(workspace_.destination().data)};
  }

 private:
  static void check(const Entry& entry, const TimedCall& call) {
    const std::string hash = hash_of(call.outcome());
    if (hash == entry.hash) return;
    throw std::runtime_error(entry.name + " gave another result (" + hash +
                             ") than was verified (" + entry.hash + ")");
  }

  const Group& group_;
  Workspace workspace_;
  /// Between the memory of rows: without them it would lie at the same place of a page in every
  /// process, and by chance at a good or a bad one.
  std::vector<detail::AlignedArray<std::uint8_t>> gaps_;
  std::map<std::string, TimedCall> calls_;
  std::set<std::size_t> checked_;
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

void measure(const std::vector<Group>& groups, std::uint64_t seed,
             const std::vector<Operation>& operations, const std::vector<TimedInput>& inputs,
             const std::function<void(const GroupTimes&)>& sink) {
  for (const std::size_t index : shuffled(groups.size(), seed)) {
    const Group& group = groups[index];
    const std::uint64_t group_seed = splitmix64(seed, index);
    Calls calls(group, group_seed, operations, inputs);
    const auto visit = [&](std::size_t entry) { return calls.visit(entry); };
    sink({index, measure_rounds(group, group_seed, visit), calls.layout()});
  }
}

MachineState machine_state() {
  constexpr int kSamples = 50;
  constexpr int kAdditions = 100'000;
  constexpr std::size_t kBytes = 64 << 10;
  std::vector<char> source(kBytes, 1);
  std::vector<char> destination(kBytes, 2);
  MachineState state{1e9, 1e9};
  for (int sample = 0; sample < kSamples; ++sample) {
    const double start = nanoseconds(CLOCK_THREAD_CPUTIME_ID);
    std::uint64_t sum = static_cast<std::uint64_t>(sample);
    for (int i = 0; i < kAdditions; ++i) {
      sum += static_cast<std::uint64_t>(i);
      asm volatile("" : "+r"(sum));
    }
    const double middle = nanoseconds(CLOCK_THREAD_CPUTIME_ID);
    for (int i = 0; i < 10; ++i) {
      std::memcpy(destination.data(), source.data(), kBytes);
      asm volatile("" : : "r"(destination.data()) : "memory");
    }
    const double end = nanoseconds(CLOCK_THREAD_CPUTIME_ID);
    state.chain_ns = std::min(state.chain_ns, (middle - start) / kAdditions);
    state.copy_ns = std::min(state.copy_ns, (end - middle) / 10);
  }
  return state;
}

}  // namespace thinbench
