// Weights as JSON files. Both kinds begin with
//     "schema": 1, "kind": "two_layer" or "cluster", "made_by": the command
// A neuron is {"weights": [8 numbers], "bias": number}. A two-layer net has "hidden", 8 neurons,
// and "output", a neuron; a cluster has "nets", up to 16 neurons with "first" and "last" descriptor
// that cover 0 to 255 in order. Further fields are ignored.
#pragma once

#include <string>
#include <variant>

#include "thinbench/nets.hpp"

namespace thinbench {

using AnyWeights = std::variant<TwoLayerWeights, ClusterWeights>;

/// No weight may be larger, so that no sum of a net leaves the range of single precision.
inline constexpr double kLargestWeight = 1e30;

/// Reads either kind. Throws std::runtime_error with one line that names the file and, where there
/// is one, the field: "weights.json: hidden[3].weights has 7 numbers; it must have 8".
[[nodiscard]] AnyWeights read_weights(const std::string& path);

/// The same for text that is at hand; `name` stands for the file in errors.
[[nodiscard]] AnyWeights parse_weights(const std::string& text, const std::string& name);

}  // namespace thinbench
