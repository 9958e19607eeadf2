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

/// What labels_json made; no border and no limit where the object is older than these.
template <class Json>
[[nodiscard]] CaseLabels labels_from(const Json& json) {
  CaseLabels labels = {json.value("operation", ""), json.value("border", "")};
  if (json.contains("max_iterations") && !json.at("max_iterations").is_null()) {
    labels.max_iterations = json.at("max_iterations").template get<int>();
  }
  return labels;
}

/// The same after "case", the unique name.
template <class Json>
[[nodiscard]] Json case_json(const Operation& operation) {
  Json json = {{"case", operation.name}};
  json.update(labels_json<Json>(operation.labels()));
  return json;
}

}  // namespace thinbench
