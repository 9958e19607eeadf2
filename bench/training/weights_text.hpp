// Weights as text: the JSON files that rules/weights_file.hpp reads, and tables.
#pragma once

#include <string>

#include "training/two_layer.hpp"

namespace thinbench {

/// The file's text. Numbers read back as the same floats.
[[nodiscard]] std::string weights_json(const TwoLayerWeights& weights, const std::string& made_by);
[[nodiscard]] std::string weights_json(const ClusterWeights& weights, const std::string& made_by);

/// A Markdown table in the layout of Table 1.
[[nodiscard]] std::string table_markdown(const HiddenLayerNet& net);

}  // namespace thinbench
