// The variants of nets, and the default nets.
#pragma once

#include <memory>
#include <vector>

#include "nets/model.hpp"
#include "thinning/state.hpp"

namespace thinbench::detail {

/// The default net of a rule; nullptr for rules that are not nets. Two-layer nets use Table 1,
/// rounded to integers for net_two_layer_rounded; the cluster uses trained_cluster.hpp, as the
/// paper publishes none. Lives as long as the program.
[[nodiscard]] std::shared_ptr<const NetModel> default_net(Rule rule);

/// The techniques that need only the net's table (lut, bitpacked, simd_bitpacked,
/// simd_bitpacked_row) are the same for all nets. They use the circuit of a rule that the net has
/// learned.
[[nodiscard]] std::vector<ThinningVariant> net_variants(Rule rule);

}  // namespace thinbench::detail
