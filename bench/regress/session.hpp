// The gate as a function.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace thinbench {

/// `machine` is where samples were measured, see machine_json. Returns the exit status; what goes
/// wrong is 2, since 1 says that a row is slower.
int run_regress(const std::vector<std::string>& arguments, const nlohmann::json& machine);

}  // namespace thinbench
