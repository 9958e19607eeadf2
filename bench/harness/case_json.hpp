// A case as JSON documents list it.
#pragma once

#include <nlohmann/json.hpp>

#include "harness/operation.hpp"

namespace thinbench {

/// "operation", "border" (empty where the operation has none) and "max_iterations" (null for no
/// limit).
template <class Json>
[[nodiscard]] Json labels_json(const CaseLabels& labels) {
  Json json = {{"operation", labels.operation}, {"border", labels.border}};
  json["max_iterations"] = labels.max_iterations ? Json(*labels.max_iterations) : Json();
  return json;
}

/// The same after "case", the unique name.
template <class Json>
[[nodiscard]] Json case_json(const Operation& operation) {
  Json json = {{"case", operation.name}};
  json.update(labels_json<Json>(operation.labels()));
  return json;
}

}  // namespace thinbench
