// Models of nets, made from weights.
#pragma once

#include "nets/model.hpp"

namespace thinbench::detail {

/// The two-layer net of section 3.2. Throws std::invalid_argument for a weight outside
/// [-1e30, 1e30].
[[nodiscard]] NetModel two_layer_model(const TwoLayerWeights& weights, Activation activation);

/// The cluster of section 3.3. Throws std::invalid_argument for a weight outside [-1e30, 1e30] and
/// for nets that do not cover the descriptors 0 to 255 in order.
[[nodiscard]] NetModel cluster_model(const ClusterWeights& weights);

}  // namespace thinbench::detail
