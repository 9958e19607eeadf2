// The variants of rules that are nets, and the nets that they use by default.
#pragma once

#include <memory>
#include <vector>

#include "nets/model.hpp"
#include "thinning/state.hpp"

namespace thinbench::detail {

/// The net that a rule uses where none is given; nullptr for rules that are no nets. The two-layer
/// nets use Table 1, rounded to integers for net_two_layer_rounded; the cluster that of
/// trained_cluster.hpp, because the paper prints none. Lives as long as the program.
[[nodiscard]] std::shared_ptr<const NetModel> default_net(Rule rule);

/// All techniques for a rule that is a net. Those that only need its table (lut, bitpacked,
/// simd_bitpacked, simd_bitpacked_row) are the same for all nets, and use a rule's own circuit
/// where the net has learned it.
[[nodiscard]] std::vector<ThinningVariant> net_variants(Rule rule);

}  // namespace thinbench::detail
