// Speed-ups, measured in pairs: plan, fresh processes, summary.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "harness/operation.hpp"
#include "paired/measuring.hpp"

namespace thinbench {

/// A control failed.
inline constexpr int kInconclusive = 3;

/// Has a process carry out an order, given as a line; see measure_in_new_process.
using Measurer =
    std::function<void(const std::string& order, std::uint64_t seed, const LineSink& answer)>;

/// The program as a function; returns the exit status. Also what a process that measures runs.
int run_paired(const std::vector<std::string>& arguments, const std::vector<Operation>& operations,
               const Measurer& measurer);

}  // namespace thinbench
