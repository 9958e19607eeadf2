// Models of nets, made from weights.
#pragma once

#include "nets/model.hpp"

namespace thinbench::detail {

/// The thinning net of section 3.2 with these weights. Throws std::invalid_argument where a weight
/// is not finite.
[[nodiscard]] NetModel two_layer_model(const TwoLayerWeights& weights, Activation activation);

/// The cluster of section 3.3. Throws std::invalid_argument where a weight is not finite or the
/// runs do not cover the descriptors 0 to 255 in order.
[[nodiscard]] NetModel cluster_model(const ClusterWeights& weights);

}  // namespace thinbench::detail
