// How long a call takes, on the clock of the thread's processor time.
#pragma once

#include <cstddef>

#include "measure/timed_row.hpp"

namespace thinbench {

/// The median over so many short epochs of warm calls; one call for slow rows.
[[nodiscard]] double seconds_of_call(const TimedRow& row, std::size_t epochs);

}  // namespace thinbench
