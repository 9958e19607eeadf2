// How long a cycle of this core is now, by code whose cycles are known.
#pragma once

namespace thinbench {

/// Seconds a cycle: the median over several short measurements of additions of which each needs the
/// result of the one before, which takes a cycle each on every x86-64 core of these years. Both
/// operands are registers, because newer cores add constants without any cycle. On the clock of
/// this thread's processor time.
[[nodiscard]] double seconds_a_cycle();

/// Seconds of processor time that this thread has used.
[[nodiscard]] double thread_seconds();

}  // namespace thinbench
