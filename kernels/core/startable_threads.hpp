// How many threads the system lets this process have. oneTBB ends the program if it cannot start
// one, so it is asked for no more than have run before.
#pragma once

namespace thinbench::detail {

/// The number of threads that can run at the same time, the calling thread included: `wanted` or,
/// where limits on processes or memory forbid so many, fewer, but at least 1. Starts threads to
/// find out; what did not start is tried again when a limit of the process has changed.
/// Thread-safe.
[[nodiscard]] int startable_threads(int wanted);

}  // namespace thinbench::detail
