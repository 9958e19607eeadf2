// Plans and samples as JSON. docs/measuring.md describes the fields.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "measure/inputs.hpp"
#include "measure/measuring.hpp"
#include "measure/plan.hpp"
#include "measure/timed_row.hpp"

namespace thinbench {

/// `selection` must hold the rows that `plan` was made of.
[[nodiscard]] nlohmann::json plan_json(const Plan& plan, const Selection& selection,
                                       const std::vector<TimedInput>& inputs,
                                       const std::vector<CalibratedRow>& rows);

/// Throws std::runtime_error where the text is no plan.
[[nodiscard]] Plan plan_from_json(const std::string& text);

[[nodiscard]] nlohmann::json group_times_json(const GroupTimes& times);

}  // namespace thinbench
