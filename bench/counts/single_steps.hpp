// Instructions counted one by one: the processor's trap flag stops after each of them. That needs
// neither hardware counters nor leave to trace, and knows every instruction that the processor
// does.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace thinbench {

/// How many instructions a call executes in this thread. None where the call takes more than
/// `max_steps`; it is finished either way. Elsewhere than on x86-64 always none, without a call. An
/// instruction that repeats itself (rep movsb) counts once, and takes a step for each repetition.
/// The call must block no signals and set no handler for SIGTRAP; two threads must not count at the
/// same time.
[[nodiscard]] std::optional<std::uint64_t> instructions_of(const std::function<void()>& call,
                                                           std::uint64_t max_steps);

}  // namespace thinbench
