// The operations that a batch can do on each image.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "batch/pipeline.hpp"
#include "cli/arguments.hpp"
#include "cli/edge_request.hpp"
#include "cli/graph_request.hpp"
#include "cli/thinning_request.hpp"
#include "images/binarise.hpp"

namespace thinbench {

struct BatchOperationRequest {
  ThinningRequest thinning;  // with the name and the ISA of any operation
  EdgeRequest edges;
  std::optional<std::int64_t> min_area;  // of holes
  GraphRequest graph;
  BinariseOptions binarise;
  std::string format;   // of images; empty: png
  std::string overlay;  // "svg" or "png"; empty: none
  std::string table;    // a file; empty: none

  // The options behind these, as some were given.
  Options of_thinning;
  Options of_edges;
  Options of_graphs;
  Options of_binarise;
};

/// Whether results are JSON instead of images, and those of graphs.
[[nodiscard]] bool makes_json(const BatchOperationRequest& request);
[[nodiscard]] bool makes_graphs(const BatchOperationRequest& request);

/// Throws UsageError, std::invalid_argument or std::runtime_error where the operation or an option
/// is unknown, does not apply or cannot be read.
[[nodiscard]] BatchOperation batch_operation(const BatchOperationRequest& request);

}  // namespace thinbench
