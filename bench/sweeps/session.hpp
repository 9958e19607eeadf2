// The program of the sweeps: plan, proof, rounds.
#pragma once

#include <string>
#include <vector>

#include "harness/operation.hpp"

namespace thinbench {

/// Ended by Ctrl-C or SIGTERM; the journal can be resumed.
inline constexpr int kInterrupted = 130;

/// The program as a function; returns the exit status.
int run_sweeps(const std::vector<std::string>& arguments, const std::vector<Operation>& operations);

}  // namespace thinbench
