// Instructions counted one by one: the processor's trap flag stops after each of them. That needs
// neither hardware counters nor leave to trace, and knows every instruction that the processor
// does.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace thinbench {

/// What a call executes in this thread.
struct ExecutedSteps {
  std::uint64_t instructions = 0;
  std::vector<std::uint64_t> addresses;  // in the order of execution, with the return of the call
};

/// None where the call takes more than `max_steps`; it is finished either way. Elsewhere than on
/// x86-64 always none, without a call. An instruction that repeats itself (rep movsb) counts once,
/// and takes a step for each repetition. The call must block no signals and set no handler for
/// SIGTRAP; two threads must not count at the same time.
[[nodiscard]] std::optional<ExecutedSteps> steps_of(const std::function<void()>& call,
                                                    std::uint64_t max_steps);

}  // namespace thinbench
