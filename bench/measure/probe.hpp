// What the processor gives at this moment: its clock, and how much of a core there is for us.
#pragma once

namespace thinbench {

/// Nanoseconds of a fixed number of independent additions of integers and vectors, as many as a
/// core can do at once: about 6 us. They take up to twice as long while the other hyperthread of
/// the core works, and follow the clock.
[[nodiscard]] double probe_ns();

/// Nanoseconds of a dependent addition, which is a clock cycle: one sample of about 5 us. What the
/// other hyperthread does hardly changes it.
[[nodiscard]] double cycle_ns();

/// Returns after at least `cycles` clock cycles.
void wait_cycles(double cycles);

}  // namespace thinbench
