// Times every row of the tables with Google Benchmark, each only after its output was compared
// with the reference's on the very input that is timed.
#pragma once

#include <vector>

#include "harness/operation.hpp"

namespace thinbench {

/// The program as a function. `arguments` are main's; returns the exit status: 2 where it was asked
/// for something that does not exist, where nothing matched and where a row was not equal to its
/// reference (it is not timed, the others are), 1 for every other failure.
int run_timings(std::vector<char*> arguments, const std::vector<Operation>& operations);

}  // namespace thinbench
