// What a measuring process does.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "harness/operation.hpp"
#include "measure/plan.hpp"
#include "measure/rounds.hpp"

namespace thinbench {

/// 16 hexadecimal digits that name a result, image and numbers.
[[nodiscard]] std::string hash_of(const Outcome& outcome);

/// What one process found in one group, in one layout.
struct GroupTimes {
  std::size_t group = 0;
  std::vector<EntryTimes> entries;
};

/// Measures all groups in one layout after the other, in an order that depends on the seed, and
/// passes each to `sink`: so the epochs of an entry are spread over the time of the process. Jobs
/// are made again for each layout. Times are those that the clock cycles of a call take at the
/// clock of the plan. The first result of each row is compared with the verified one by its hash.
/// Throws std::runtime_error for another result or an unknown row.
void measure(const Plan& plan, std::uint64_t seed, const std::vector<Operation>& operations,
             const std::vector<TimedInput>& inputs,
             const std::function<void(const GroupTimes&)>& sink);

/// Nanoseconds of a dependent addition, which is a clock cycle: one sample of about 5 us.
[[nodiscard]] double cycle_ns();

/// The shortest of many samples, about 2 ms in all. Wall-clock time: in a virtual machine the clock
/// of the thread's processor time omits what it takes for stolen, and reads up to 30 % too little
/// for one sample in 10,000, which a minimum would find.
[[nodiscard]] double shortest_cycle_ns();

}  // namespace thinbench
