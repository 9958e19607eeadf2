// The program started afresh.
#pragma once

#include <cstdint>
#include <string>

#include "paired/measuring.hpp"

namespace thinbench {

/// Starts this program again with `--measure-with-seed SEED`, gives it the order on standard input
/// and passes on every line of its answer. Throws std::runtime_error where that process fails.
void measure_in_new_process(const std::string& order, std::uint64_t seed, const LineSink& answer);

}  // namespace thinbench
