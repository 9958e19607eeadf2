// Thresholds of edges: the commands that mark edges take the same.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "images/binarise.hpp"
#include "thinbench/edges.hpp"

namespace thinbench {

struct EdgeRequest {
  int gradient_threshold = EdgeThresholds{}.gradient_threshold;
  std::optional<int> brightness_threshold;  // default: the highest grey level of the foreground
};

/// --gradient-threshold and --brightness-threshold.
void add_edge_thresholds(CLI::App& app, EdgeRequest& request);

/// Makes the background the bright side: inverts the image if its foreground is bright. `binary`
/// was made from it.
[[nodiscard]] EdgeThresholds prepare_for_edges(ByteImage& grey, const BinaryImage& binary,
                                               const EdgeRequest& request);

}  // namespace thinbench
