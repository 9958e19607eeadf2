// What nets decide, as tables.
#pragma once

#include "thinbench/nets.hpp"
#include "thinbench/window_table.hpp"

namespace thinbench::detail {

/// The two-layer net of section 3.2. Throws std::invalid_argument for a weight outside
/// [-1e30, 1e30].
[[nodiscard]] WindowTable table_of(const TwoLayerWeights& weights, Activation activation);

/// The cluster of section 3.3. Throws std::invalid_argument for a weight outside [-1e30, 1e30] and
/// for nets that do not cover the descriptors 0 to 255 in order.
[[nodiscard]] WindowTable table_of(const ClusterWeights& weights);

}  // namespace thinbench::detail
